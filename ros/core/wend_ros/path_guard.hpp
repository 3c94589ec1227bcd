#pragma once

// PathGuard: may a robot drive on along its route, on the map as it is now? It sweeps the robot along the next part of
// the route: as far as the robot needs to stop from its highest speed, and look_ahead more. Knows no ROS.
//
//   const wend_ros::PathGuard guard(limits, 0.05, {});
//   const auto fault = guard.why_blocked({space, path_in_map}, route,
//                                         {follower.leg(), follower.along_leg(), pose});
//   if (fault) brake(*fault);
//
// Metres, radians and seconds, in the frame of the route.

#include <cstddef>
#include <optional>
#include <string>

#include "wend/control/motion_model.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/free_space.hpp"

namespace wend_ros {

/// How a route is tested.
struct GuardOptions {
  double look_ahead = 0.5;
  double path_margin = 0.02;
  double join_margin = 0.1;
  double escape = 0.25;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"look_ahead", "length of path beyond the braking distance that must be free, m"},
          self.look_ahead, {0, 100});
    field({"path_margin",
           "how much smaller than the robot the shape is that is swept along the path, m"},
          self.path_margin, {0, 10});
    field({"join_margin",
           "how much smaller than the robot's inscribed disc the disc is that is swept along the "
           "line to the path, m"},
          self.join_margin, {0, 10});
    field({"escape", "length of path on which a robot that overlaps an obstacle may leave it, m"},
          self.escape, {0, 10});
  }
};

/// The shape that is swept: smaller by the margin at its farthest point, less elsewhere.
wend::Footprint swept_footprint(const wend::Footprint& robot, double margin);

/// The map of now for the swept shape, and where the route's frame lies in the map's.
struct GuardedSpace {
  const wend::FreeSpace& space;
  wend::MapPose route_in_map = {};
};

/// Where a robot is on a route.
struct RobotOnRoute {
  std::size_t leg = 0;
  double along_leg = 0;
  std::optional<wend::MapPose> pose =
      {};  // in the route's frame; unset: it stands on the route and faces along it
};

class PathGuard {
 public:
  /// `period`: between two tests. `inscribed_radius`: of the robot.
  PathGuard(const wend::VelocityLimits& limits, double period, double inscribed_radius,
            const GuardOptions& options);

  /// How much of the route ahead is tested.
  double reach() const { return reach_; }

  /// Why the robot must not drive on from that place of the route, if it must not: "blocked 0.8 m ahead, at (3.2, 1.5):
  /// the path enters an obstacle". At the beginning of a leg, the turn that makes it face along the leg is swept first.
  /// A robot that overlaps an obstacle there may leave it, within `escape`, as long as it never overlaps more of it
  /// (wend::check_with_lead()).
  std::optional<std::string> why_blocked(const GuardedSpace& on, const wend::Route& route,
                                         const RobotOnRoute& robot) const;

  /// Is the straight line free?
  bool can_reach(const GuardedSpace& on, wend::MapPoint from, wend::MapPoint to) const;

 private:
  double reach_;
  double join_radius_;
  double escape_;
};

}  // namespace wend_ros
