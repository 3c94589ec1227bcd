#pragma once

// Follower: drives a robot along a route with a controller, command by command. It tracks the
// robot's progress and reports when the robot has arrived, is stuck, or has left the path. The
// simulator and the ROS node use the same class.
//
//   wend::Follower follower(*controller);  // the controller outlives it
//   follower.follow(wend::Route(path, frame));
//   const wend::FollowerStep step = follower.step(pose, 0.05);
//   if (step.state == wend::FollowerState::driving) robot.go(step.command);
//
// Metres, radians, seconds, in the map's frame.

#include <cstddef>

#include "wend/base/compiler.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/route.hpp"

namespace wend {

/// When a waypoint or the goal is reached, and when the robot is stuck or lost.
struct FollowerOptions {
  double acceptance_radius = 0.15;  // m: a waypoint nearer than this is reached
  double goal_tolerance = 0.1;      // m
  double heading_tolerance = 0.1;   // rad: of a goal with a heading; 0 = any heading
  double off_path = 1;              // m: farther from the route than this is lost
  double stuck_time = 10;           // s
  double heading_window = 0.3;      // m: the route's heading is a mean over this length either way
  bool turns_in_place = true;  // can the robot turn in place? Not an option: simulate() sets it

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"acceptance_radius", "distance at which a waypoint counts as reached, m"},
          self.acceptance_radius, {1e-3, 1e3});
    field({"goal_tolerance", "distance at which the goal counts as reached, m"},
          self.goal_tolerance, {1e-3, 1e3});
    field({"heading_tolerance",
           "largest heading error at a goal that has a heading, rad; 0 = any heading"},
          self.heading_tolerance, {0, 3.2});
    field({"off_path", "distance from the path at which the robot counts as lost, m"},
          self.off_path, {1e-2, 1e6});
    field({"heading_window",
           "length of path before and ahead of the robot over which its heading is averaged, m"},
          self.heading_window, {0, 1e3});
    field({"stuck_time", "time without progress after which the robot counts as stuck, s"},
          self.stuck_time, {1e-1, 1e6});
  }
};

/// How a robot's drive along a route stands.
enum class FollowerState {
  driving,   // on its way
  reached,   // stands within the tolerances of the route's end
  stuck,     // no progress for stuck_time; a robot that cannot turn stands in the wrong heading
  off_path,  // too far from the route
  invalid,   // the route is not valid(), or the controller's command is not finite
};

/// The answer to one pose: what the robot is to do, and how it stands.
struct FollowerStep {
  Velocity command{};                            // within the robot's limits
  FollowerState state = FollowerState::driving;  // after this step
  double heading_error = 0;  // rad, in (-pi, pi]: to the route's heading at the robot, averaged
                             // over the heading window (Polyline::heading_at)
  double cross_track = 0;    // m, to the route, unsigned
};

/// Drives a robot along a route. Every run ends, whatever the controller does: progress is 0.05 m along
/// the route or towards it, or a heading error 0.1 rad smaller than at the last progress; for robots that
/// are too slow for that, it is a tenth of what they can do in stuck_time.
class WEND_API Follower {
 public:
  /// The controller must outlive the follower.
  explicit Follower(Controller& controller, VelocityLimits limits = {},
                    FollowerOptions options = {});

  /// Begins a new route, also while driving. The robot continues from the nearest point of the
  /// route's beginning, which is off_path plus the length of a second's drive.
  void follow(Route route);

  /// The next command, from the measured pose, `seconds` (> 0) after the last one. It is within the
  /// limits. Before follow() the state is reached. If the pose is not finite, the robot brakes. In
  /// every state other than driving it also brakes, and the state stays. O(lines of the route that
  /// the robot can reach within a second); allocates only what a controller needs for a new route.
  FollowerStep step(const MapPose& pose, double seconds);

  /// Other limits, from the next command on, also while driving. The controller begins the rest of the
  /// leg with them.
  void set_limits(const VelocityLimits& limits);
  /// The limits of the commands.
  const VelocityLimits& limits() const { return limits_; }

  /// The robot's velocity, if it is not the one that step() commanded last: the next command is within
  /// reach of it.
  void set_velocity(const Velocity& velocity) { velocity_ = velocity; }

  /// The robot's progress along the route, m.
  double along() const { return behind_ + along_; }

  /// The index of the current leg of the route.
  std::size_t leg() const { return leg_; }
  /// The progress along the current leg, m.
  double along_leg() const { return along_; }

 private:
  const RouteLeg& current_leg() const { return route_.legs()[leg_]; }
  bool is_last_leg() const { return leg_ + 1 == route_.legs().size(); }

  void begin_leg(std::size_t leg);
  FollowerStep brake(double seconds);
  void locate(const MapPose& shown);
  bool is_at_end_of_leg(const MapPose& pose);
  Velocity ask_controller(const MapPose& shown, double turn, double seconds);
  void arrive(const MapPose& pose, double seconds);
  void watch_progress(double headway, double heading_error, double seconds);

  Controller* controller_;
  VelocityLimits limits_;
  FollowerOptions options_;
  Route route_{Path::along({Point{}}), Frame{}};

  FollowerState state_ = FollowerState::reached;
  Velocity velocity_{};  // as last commanded
  std::size_t leg_ = 0;
  double behind_ = 0;  // the legs that are done
  double along_ = 0;   // of this leg
  double cross_track_ = 0;
  std::size_t waypoint_ = 0;
  bool turns_ = false;      // in place, before it drives along the leg
  double nearest_end_ = 0;  // m, how near it came to the leg's end
  bool arrives_ = false;    // within the goal's tolerance: only brakes and turns from now on

  double best_headway_ = 0;
  double least_heading_error_ = 0;
  double idle_ = 0;  // s since the last progress
};

}  // namespace wend
