#pragma once

// Where the robot is, in a map's frame: its tf if there is one, else the last /initialpose, else the
// parameter. And poses of other frames in that one.

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <mutex>
#include <optional>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"

namespace wend_ros {

class RobotPose {
 public:
  RobotPose(ros::NodeHandle& node, ros::NodeHandle& own);

  /// The robot's pose, or why it is unknown.
  wend::Expected<wend::MapPose, std::string> in(const std::string& frame_id) const;

  /// A pose in that frame; an empty frame_id is that one. Or why tf2 cannot take it there.
  wend::Expected<wend::MapPose, std::string> in(const std::string& frame_id,
                                                const geometry_msgs::PoseStamped& pose) const;

 private:
  void take(const geometry_msgs::PoseWithCovarianceStamped& message);

  std::string robot_frame_;
  std::optional<wend::MapPose> parameter_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::Subscriber subscriber_;
  mutable std::mutex mutex_;
  std::optional<geometry_msgs::PoseStamped> initial_;
};

}  // namespace wend_ros
