// SPDX-License-Identifier: Apache-2.0
#include "plan_messages.hpp"

#include <cmath>

#include "pose_messages.hpp"

namespace wend_ros {
namespace {

using visualization_msgs::msg::Marker;

constexpr float kLineWidth = 0.05F;   // m
constexpr float kArrowLength = 0.4F;  // m

Marker marker(const std_msgs::msg::Header& header, int id, int type) {
  Marker made;
  made.header = header;
  made.ns = "plan";
  made.id = id;
  made.type = type;
  made.pose.orientation.w = 1;
  made.color.a = 1;
  return made;
}

Marker arrow(const nav_msgs::msg::Path& path, int id, const geometry_msgs::msg::Pose& pose) {
  Marker made = marker(path.header, id, Marker::ARROW);
  made.pose = pose;
  made.scale.x = kArrowLength;
  made.scale.y = made.scale.z = 2 * kLineWidth;
  return made;
}

}  // namespace

wend::Expected<OccupancyLayout, wend::Error> layout_of(const nav_msgs::msg::OccupancyGrid& map) {
  const auto origin = wend_nav2::pose_from(map.info.origin, wend_nav2::Tilt::flat);
  if (!origin) {
    return wend::failure(wend::Status::invalid_map, "the map's origin: " + origin.error());
  }
  return OccupancyLayout{
      .frame_id = map.header.frame_id,
      .width = map.info.width,
      .height = map.info.height,
      .frame = {
          .resolution = map.info.resolution, .origin = *origin, .y_up = true, .metric = true}};
}

OccupancyUpdate update_of(const map_msgs::msg::OccupancyGridUpdate& update) {
  return {.frame_id = update.header.frame_id,
          .x = update.x,
          .y = update.y,
          .width = update.width,
          .height = update.height,
          .values = update.data};
}

StatusCode code_of(wend_nav2::FailureKind kind) {
  using wend_nav2::FailureKind;
  switch (kind) {
    case FailureKind::invalid_planner:
      return StatusCode::invalid_planner;
    case FailureKind::tf_error:
      return StatusCode::tf_error;
    case FailureKind::start_outside:
      return StatusCode::start_outside;
    case FailureKind::goal_outside:
      return StatusCode::goal_outside;
    case FailureKind::start_occupied:
      return StatusCode::start_blocked;
    case FailureKind::goal_occupied:
      return StatusCode::goal_blocked;
    case FailureKind::timed_out:
      return StatusCode::timeout;
    case FailureKind::no_valid_path:
      return StatusCode::no_valid_path;
    case FailureKind::cancelled:
      return StatusCode::cancelled;
    case FailureKind::other:
      break;
  }
  return StatusCode::unknown_error;
}

double length_of(const nav_msgs::msg::Path& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.poses.size(); ++i) {
    const auto& a = path.poses[i - 1].pose.position;
    const auto& b = path.poses[i].pose.position;
    length += std::hypot(b.x - a.x, b.y - a.y);
  }
  return length;
}

visualization_msgs::msg::MarkerArray markers_of(const nav_msgs::msg::Path& path) {
  visualization_msgs::msg::MarkerArray markers;
  Marker clear = marker(path.header, 0, Marker::LINE_STRIP);
  clear.action = Marker::DELETEALL;
  markers.markers.push_back(clear);
  if (path.poses.empty()) return markers;
  Marker line = marker(path.header, 1, Marker::LINE_STRIP);
  line.scale.x = kLineWidth;
  line.color.b = 1;
  for (const auto& stamped : path.poses) line.points.push_back(stamped.pose.position);
  Marker start = arrow(path, 2, path.poses.front().pose);
  start.color.g = 1;
  Marker goal = arrow(path, 3, path.poses.back().pose);
  goal.color.r = 1;
  markers.markers.insert(markers.markers.end(), {line, start, goal});
  return markers;
}

}  // namespace wend_ros
