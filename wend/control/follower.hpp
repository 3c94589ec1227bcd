#pragma once

// Follower: drives a robot along a route with a controller, command by command. It keeps track of how
// far the robot has come, and says when it has arrived, is stuck, or has left the path. The simulator
// and a real robot's node use the same one.
//
//   wend::Follower follower(*controller);  // the controller outlives it
//   follower.follow(wend::Route(path, frame));
//   const wend::FollowerStep step = follower.step(pose, 0.05);
//   if (step.state == wend::FollowerState::driving) robot.go(step.command);
//
// Metres, radians, seconds, in the map's frame.

#include <optional>
#include <string_view>
#include <vector>

#include "wend/control/controller.hpp"
#include "wend/control/route.hpp"

namespace wend {

struct FollowerOptions {
  double acceptance_radius = 0.15;  // m: a waypoint nearer than this is reached
  double goal_tolerance = 0.1;      // m
  double heading_tolerance = 0;     // rad: turns on the spot at the goal until within; 0 = any
  double off_path = 1;              // m: farther from the route than this is lost
  double stuck_time = 10;           // s without 0.05 m or 0.1 rad of progress

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"acceptance_radius", "a waypoint nearer than this is reached, m"},
          self.acceptance_radius, {1e-3, 1e3});
    field({"goal_tolerance", "the goal is reached within this, m"}, self.goal_tolerance,
          {1e-3, 1e3});
    field({"heading_tolerance", "and within this of its heading, rad; 0 = any heading"},
          self.heading_tolerance, {0, 3.2});
    field({"off_path", "farther from the path than this is lost, m"}, self.off_path, {1e-2, 1e6});
    field({"stuck_time", "without progress for this long is stuck, s"}, self.stuck_time,
          {1e-1, 1e6});
  }
};

enum class FollowerState { driving, reached, stuck, off_path };

struct FollowerStep {
  Velocity command{};
  FollowerState state = FollowerState::driving;
  double heading_error = 0;  // rad, of the route where the robot is
  double cross_track = 0;    // m, to the route, unsigned
};

class Follower {
 public:
  explicit Follower(Controller& controller, VelocityLimits limits = {},
                    FollowerOptions options = {});

  /// Begins a new route; also while driving, where the robot goes on from the nearest point ahead.
  void follow(Route route);

  /// The next command, from the pose that was measured, `seconds` (> 0) after the last one. O(lines
  /// of the route within reach).
  FollowerStep step(const Pose& pose, double seconds);

  /// How far along the route the robot has come, m.
  double along() const;

 private:
  // (state)
};

}  // namespace wend
