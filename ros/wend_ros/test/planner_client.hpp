#pragma once

// What the tests ask the planner's node, and with what.

#include <geometry_msgs/PoseStamped.h>
#include <wend_ros/PlanRequest.h>

#include <string>

namespace wend_ros {

inline geometry_msgs::PoseStamped pose(double x, double y, const std::string& frame_id = "map") {
  geometry_msgs::PoseStamped stamped;
  stamped.header.frame_id = frame_id;
  stamped.pose.position.x = x;
  stamped.pose.position.y = y;
  stamped.pose.orientation.w = 1;
  return stamped;
}

/// From (1.5,1.5), on any of the tests' maps.
inline PlanRequest request(double x, double y) {
  PlanRequest request;
  request.use_start = 1;
  request.start = pose(1.5, 1.5);
  request.goals = {pose(x, y)};
  return request;
}

}  // namespace wend_ros
