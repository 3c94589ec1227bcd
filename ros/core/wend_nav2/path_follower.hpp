// SPDX-License-Identifier: Apache-2.0
#pragma once

// PathFollower: follows the path of any planner with one of wend's controllers, command by command, and stays free on
// the costs of a costmap. Knows no ROS; one thread at a time.
//
//   PathFollower follower;
//   follower.set(settings);
//   follower.set_path(poses);                       // in the path's frame
//   follower.costmap().read(layout, costs);         // with the costmap's lock
//   const auto velocity = follower.command(moment);
//   if (!velocity) throw_as_nav2(velocity.error());
//
// A path is driven ahead or in reverse as its poses face (wend/control/given_route.hpp), and its legs between reversals
// and turns in place one by one. The path and the costmap may have different frames: the path is followed in its own one,
// and the costmap is only asked for the room to stop in (safe_velocity.hpp). Cells show an obstacle's edge to half a cell:
// where the path leads into an obstacle, the robot therefore stops half a cell before it.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/control/controller.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/session/session.hpp"
#include "wend_nav2/control_settings.hpp"
#include "wend_nav2/costmap_copy.hpp"
#include "wend_nav2/frame_change.hpp"
#include "wend_nav2/robot_shape.hpp"

namespace wend_nav2 {

/// Why there is no command, as one of the kinds of errors that Nav2 has.
enum class ControlFailureKind {
  invalid_path,      // no path or one of NaN; the robot is too far from it
  no_progress,       // the robot does not get on
  no_valid_control,  // the robot is in an obstacle, or cannot drive on without a collision
  old_pose,          // where the robot is now is not known
  other,             // the costmap is not valid, or what was measured is not finite
};

/// The name in the enum.
std::string_view to_string(ControlFailureKind kind);

struct ControlFailure {
  ControlFailureKind kind = ControlFailureKind::other;
  std::string message = {};  // a sentence that says where and why
};

/// What a command depends on.
struct ControlMoment {
  wend::MapPose on_path = {};     // the robot's pose, in the path's frame
  wend::MapPose in_costmap = {};  // the same in the costmap's frame
  wend::Velocity velocity = {};   // as measured
  RobotShape robot = {};
  double seconds = 0.05;  // for which the command will be held, > 0
  double age = 0;         // of the poses, s
};

class PathFollower {
 public:
  PathFollower() = default;
  PathFollower(const PathFollower&) = delete;
  PathFollower& operator=(const PathFollower&) = delete;

  /// For the paths from now on; ControlOptions from now on.
  void set(ControlSettings settings);

  /// When the goal counts as reached, for the paths from now on: metres, and radians, 0 if any heading will do. The
  /// robot drives closer than that. A tolerance that is not finite, or negative, leaves the one before.
  void set_goal_tolerance(double distance, double heading);

  /// At most so many metres a second from now on. 0: as fast as the settings say. False, and the limit stays as it
  /// was, if it is not finite or negative.
  bool set_speed_limit(double speed);
  /// The same in percent of the settings' speed; 0: as fast as they say.
  bool set_speed_limit_percent(double percent);

  /// Takes another path, also while driving. The robot joins it where it can get to along a free line
  /// (wend/control/joining.hpp). The path that is being driven already changes nothing, and a new one does not give a
  /// robot that makes no progress more time. Fails, with the place, if the path is empty or has a pose that fault_of()
  /// finds; then there is no path.
  wend::Expected<void, ControlFailure> set_path(const std::vector<wend::MapPose>& path);

  CostmapCopy& costmap() { return costmap_; }

  /// What to drive now; never NaN. Each failure leaves the robot standing.
  wend::Expected<wend::Velocity, ControlFailure> command(const ControlMoment& moment);

  /// From now on command() brakes. True once the robot was told to stand.
  bool stop();

  /// Forgets the path; the robot keeps its velocity until the next one comes. For a path in another frame.
  void forget_path();

  /// Forgets the path and the velocity. The robot is told to stand by whoever calls this.
  void reset();

 private:
  wend::VelocityLimits limits() const;
  void limit_speed();
  wend::Expected<void, ControlFailure> make_follower();
  wend::Expected<wend::FreeSpace, ControlFailure> space(const RobotShape& robot);
  bool can_reach(const wend::MapPose& from, wend::MapPoint to) const;
  wend::Expected<wend::Velocity, ControlFailure> wanted(const ControlMoment& moment);
  std::optional<wend::Velocity> safe(const ControlMoment& moment, const wend::Velocity& before,
                                     const wend::Velocity& want, const wend::FreeSpace& free) const;
  bool is_at_goal(const wend::MapPose& pose) const;

  ControlSettings settings_;
  wend::Session session_;
  CostmapCopy costmap_;
  std::unique_ptr<wend::Controller> controller_;
  std::optional<wend::Follower> follower_;  // with the controller
  std::optional<wend::Route> route_;        // along the path; nothing: there is none
  // What a path that begins may look at: the costmap at this moment.
  std::optional<wend::FreeSpace> free_;
  std::optional<FrameChange> to_costmap_;
  wend::Velocity told_ = {};  // last
  bool begins_ = true;        // the robot's velocity counts, not what it was told
  bool stops_ = false;
  bool is_set_anew_ = false;  // the settings or the tolerances, since the follower was made
  double speed_limit_ = 0;    // m/s; 0: none
  double speed_share_ = 1;
  double goal_distance_ = 0.25;
  double goal_heading_ = 0.25;
};

}  // namespace wend_nav2
