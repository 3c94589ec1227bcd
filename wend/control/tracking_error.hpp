#pragma once

// What controllers steer by: where the next waypoint lies, and how much of the route is left.

#include "wend/control/controller.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// How far the robot must turn to face a point, in (-pi, pi]; 0 where it stands on it.
double turn_to(const Pose& pose, Point point);

/// What is left of a route: along it and, where that has come to its end, straight to the end.
double way_left(const Polyline& route, double along, Point point);

/// The errors that P and PID controllers feed back.
struct TrackingError {
  double heading = 0;   // rad, to face the next waypoint
  double distance = 0;  // m, what is left
};

TrackingError tracking_error_of(const ControllerInput& input);

/// Drives so fast, but slower the larger the heading error is, and not at all from `standing_angle`
/// on; and turns so fast.
Velocity while_turning(double linear, double angular, const TrackingError& aim,
                       double standing_angle, const VelocityLimits& limits);

}  // namespace wend
