#pragma once

// Poses as messages. A pose that is not finite, absurdly far away, or whose orientation is not a heading is refused
// with the reason.

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>

#include <string>

#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend_ros/given_path.hpp"
#include "wend_ros/orientation.hpp"

namespace wend_ros {

geometry_msgs::Pose to_message(const wend::MapPose& pose);

/// What a message says.
GivenPose given_pose(const geometry_msgs::Pose& message);

Orientation orientation_of(const geometry_msgs::Quaternion& turn);

/// The pose of a message, or why it is none: "contains NaN or infinity", or as heading_of() says.
wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::Pose& message);

/// The same for a pose that tf2 has taken to another frame: as heading_of_frame() says.
wend::Expected<wend::MapPose, std::string> moved_pose_from(const geometry_msgs::Pose& message);

/// Where a frame of tf2 lies.
wend::Expected<wend::MapPose, std::string> pose_from(const geometry_msgs::Transform& transform);

}  // namespace wend_ros
