#pragma once

// Poses and paths as messages give them, and what a follower makes of them. Knows no ROS: pose_message.hpp and
// path_message.hpp copy the messages.
//
//   const auto route = wend_ros::route_from(path);
//   if (!route) return warn(route.error().message);  // "pose 20 of the path contains NaN or infinity"
//   follower.follow(*route);

#include <cstdint>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/path/trajectory.hpp"
#include "wend_ros/orientation.hpp"

namespace wend_ros {

/// As geometry_msgs/Pose has it.
struct GivenPose {
  double x = 0;
  double y = 0;
  double z = 0;
  Orientation orientation = {};
};

/// As time of ROS has it.
struct GivenTime {
  std::uint32_t sec = 0;
  std::uint32_t nsec = 0;
};

/// Of any two stamps, also such that are 68 years apart, as wrong ones are.
double seconds_between(const GivenTime& from, const GivenTime& to);

/// As geometry_msgs/PoseStamped has it.
struct GivenStampedPose {
  std::string frame_id = {};
  GivenTime stamp = {};
  GivenPose pose = {};
};

/// As nav_msgs/Path has it.
struct GivenPath {
  std::string frame_id = {};
  std::vector<GivenStampedPose> poses = {};
};

/// The pose that is meant, or why it is none: "contains NaN or infinity", or as heading_of() says.
wend::Expected<wend::MapPose, std::string> pose_from(const GivenPose& given);

/// The same for a pose that tf2 has taken to another frame, or where a frame lies: as heading_of_frame() says.
wend::Expected<wend::MapPose, std::string> moved_pose_from(const GivenPose& given);

/// The trajectory of poses with time stamps; it starts with the first stamp. Fails as wend::Trajectory::through() does,
/// for a pose that pose_from() refuses, and for one in another frame than the path.
wend::Expected<wend::Trajectory, wend::Error> trajectory_from(const GivenPath& path);

/// The route of a path whose headings count, such as a trajectory's. Fails for poses as trajectory_from() does.
wend::Expected<wend::Route, wend::Error> route_through(const GivenPath& path);

/// The route of a path from here or elsewhere: wend::given_route() says whether its headings count. If no
/// orientation is set, all being zeros, it has no headings. Fails for poses as trajectory_from() does, and without any.
wend::Expected<wend::Route, wend::Error> route_from(const GivenPath& path);

}  // namespace wend_ros
