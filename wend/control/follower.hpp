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
#include <limits>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/joining.hpp"
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
  bool moves_aside =
      false;  // can it move to its sides? Likewise; else it turns to where a leg leads

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
  reached,   // stands within the tolerances of the route's end, as far as its poses tell
  stuck,     // no progress for stuck_time, or it stands at the end outside the tolerances for good
  off_path,  // too far from the route
  invalid,  // the route is not valid(), or a limit, a period or the controller's command is not finite
};

/// The answer to one pose: what the robot is to do, and how it stands.
struct FollowerStep {
  Velocity command{};                            // within the robot's limits
  FollowerState state = FollowerState::driving;  // after this step
  double heading_error = 0;  // rad, in (-pi, pi]: to the route's heading at the robot, averaged
                             // over the heading window (Polyline::heading_at)
  double cross_track = 0;    // m, to the route, unsigned
  bool lost = false;         // the pose is not finite: it brakes until one is
};

/// Drives a robot along a route. Every run ends, whatever the controller does: progress is 0.05 m along
/// the route or towards it, or a heading error 0.1 rad smaller than at the last progress; for robots that
/// are too slow for that, it is a tenth of what they can do in stuck_time.
class WEND_API Follower {
 public:
  /// The controller must outlive the follower.
  explicit Follower(Controller& controller, VelocityLimits limits = {},
                    FollowerOptions options = {});

  /// Begins a new route, also while driving. The robot joins it at place_to_join() within off_path, of what
  /// `can_reach` lets it reach; where there is no such place, at its start. The route that it is driving changes
  /// nothing, and a new one does not give a robot that makes no progress more time.
  void follow(Route route, FreeLine can_reach = {});

  /// The next command, from the measured pose, `seconds` (> 0) after the last one. It is within the limits.
  /// Before follow() the state is reached. At the route's end, a robot that overshoots drives back. If the pose
  /// is not finite, the robot brakes. In every state other than driving it also brakes, and the state stays.
  /// O(lines of the route that the robot can reach within a second; all at the first step of a route); takes memory
  /// only where a robot drives to the end of a route beside which it stands.
  FollowerStep step(const MapPose& pose, double seconds);

  /// Other limits, from the next command on, also while driving. The controller begins the rest of the
  /// leg with them.
  void set_limits(const VelocityLimits& limits);
  /// The limits of the commands.
  const VelocityLimits& limits() const { return limits_; }

  /// The robot's velocity, if it is not the one that step() commanded last: the next command is within
  /// reach of it. One that is not finite counts as standing.
  void set_velocity(const Velocity& velocity);

  /// The robot's progress along the route, m.
  double along() const { return behind_ + along_leg(); }

  /// The index of the current leg of the route.
  std::size_t leg() const { return leg_; }
  /// The progress along the current leg, m.
  double along_leg() const { return way_to_end_ ? leg_of_route().line.length() : along_; }

 private:
  const RouteLeg& leg_of_route() const { return route_.legs()[leg_]; }
  const RouteLeg& current_leg() const { return way_to_end_ ? *way_to_end_ : leg_of_route(); }
  bool is_last_leg() const { return leg_ + 1 == route_.legs().size(); }
  double gap_to_end(const MapPose& pose) const;
  double course() const { return options_.moves_aside ? current_leg().course : 0; }

  void join(const MapPose& pose);
  void begin_leg(std::size_t leg);
  void drive_to_end(const MapPose& pose, bool may_reverse);
  FollowerStep brake(double seconds);
  void locate(const MapPose& shown);
  bool is_at_end_of_leg(const MapPose& pose);
  void drive(const MapPose& pose, const MapPose& shown, double seconds);
  Velocity ask_controller(const MapPose& shown, double turn, double seconds);
  void begin_to_arrive(const MapPose& pose);
  void arrive(const MapPose& pose, double seconds);
  bool stands(const MapPose& pose, double seconds);
  void watch_progress(double headway, double heading_error, double seconds);

  Controller* controller_;
  VelocityLimits limits_;
  FollowerOptions options_;
  Route route_{Path::along({Point{}}), Frame{}};

  FollowerState state_ = FollowerState::reached;
  Velocity velocity_{};  // as last commanded
  bool joins_ = false;   // at the next pose
  FreeLine can_reach_;
  std::size_t leg_ = 0;
  std::optional<RouteLeg>
      way_to_end_;  // in place of the last leg, for a robot that stands beside its end
  int ways_to_end_ = 0;
  double cautious_speed_ = std::numeric_limits<double>::infinity();  // m/s, on that way
  double behind_ = 0;                                                // the legs that are done
  double along_ = 0;                                                 // of this leg
  double cross_track_ = 0;
  std::size_t waypoint_ = 0;
  bool turns_ = false;      // in place, before it drives along the leg
  double nearest_end_ = 0;  // m, how near it came to the leg's end
  bool arrives_ = false;    // within the goal's tolerance: only brakes and turns from now on
  bool turns_at_end_ = false;

  std::optional<MapPose> seen_;  // at the last step that drove
  MapPose seen_then_;            // some time ago
  double waited_ = 0;            // s since then, told to stand

  double best_headway_ = 0;  // minus infinity: not known yet
  double least_heading_error_ = 0;
  double idle_ = 0;  // s since the last progress
};

}  // namespace wend
