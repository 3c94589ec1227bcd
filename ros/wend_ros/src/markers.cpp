#include "wend_ros/markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/outline_poses.hpp"
#include "wend/path/polyline.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend_ros/map_message.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

using visualization_msgs::Marker;

struct Rgb {
  float red;
  float green;
  float blue;
};
constexpr Rgb kRed{0.78F, 0.14F, 0.17F};
constexpr Rgb kYellow{0.95F, 0.77F, 0.06F};
constexpr Rgb kGreen{0.0F, 0.62F, 0.45F};
constexpr Rgb kOrange{0.84F, 0.37F, 0.0F};
constexpr Rgb kBlue{0.0F, 0.45F, 0.7F};
constexpr double kThin = 0.02;  // m: flat things

std_msgs::ColorRGBA colour_of(const Rgb& colour) {
  std_msgs::ColorRGBA message;
  message.r = colour.red;
  message.g = colour.green;
  message.b = colour.blue;
  message.a = 1;
  return message;
}

Marker marker_of(const std::string& frame_id, const std::string& name, int type,
                 const Rgb& colour) {
  Marker marker;
  marker.header.frame_id = frame_id;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.color = colour_of(colour);
  return marker;
}

geometry_msgs::Point point_of(wend::MapPoint at, double z) {
  geometry_msgs::Point point;
  point.x = at.x;
  point.y = at.y;
  point.z = z;
  return point;
}

/// A marker without points would be an error to rviz.
void finish(Marker& marker) {
  if (marker.points.empty()) marker.action = Marker::DELETE;
}

/// As long as the robot, or half a metre for a point.
double arrow_length(const wend::Footprint& footprint) {
  return footprint.is_point() ? 0.5 : std::clamp(footprint.circumscribed_radius(), 0.2, 2.0);
}

Marker end_marker(const wend::MapPose& end, const std::string& frame_id, const std::string& name,
                  const Rgb& colour, double length) {
  Marker marker = marker_of(frame_id, name, Marker::ARROW, colour);
  marker.pose = to_message(end);
  marker.scale.x = length;
  marker.scale.y = length / 3;
  marker.scale.z = length / 3;
  return marker;
}

/// The corners of a polygon, or points on the circle of a disc, where the robot stands at a pose.
std::vector<wend::MapPoint> outline_at(const wend::Footprint& footprint,
                                       const wend::MapPose& pose) {
  std::vector<wend::MapPoint> points;
  if (footprint.outline() != nullptr) {
    // The footprint is in metres: metres are the grid's units here.
    const wend::PlacedPolygon placed(*footprint.outline(), {pose.x, pose.y, pose.heading});
    for (const wend::Point corner : placed.corners()) points.push_back({corner.x, corner.y});
    return points;
  }
  constexpr int kPointsOfACircle = 24;
  for (int i = 0; i < kPointsOfACircle; ++i) {
    const double angle = 2 * wend::kPi * i / kPointsOfACircle;
    points.push_back({pose.x + footprint.circumscribed_radius() * std::cos(angle),
                      pose.y + footprint.circumscribed_radius() * std::sin(angle)});
  }
  return points;
}

/// A chevron from one side of an outline to its front and to the other side: which way it faces. A line
/// ahead would lie on the path.
std::array<wend::MapPoint, 3> chevron_in(const std::vector<wend::MapPoint>& outline,
                                         const wend::MapPose& pose) {
  const double x = std::cos(pose.heading);
  const double y = std::sin(pose.heading);
  double front = 0;
  double side = 0;
  for (const wend::MapPoint at : outline) {
    front = std::max(front, (at.x - pose.x) * x + (at.y - pose.y) * y);
    side = std::max(side, std::abs((at.y - pose.y) * x - (at.x - pose.x) * y));
  }
  return {{{pose.x - side * y, pose.y + side * x},
           {pose.x + front * x, pose.y + front * y},
           {pose.x + side * y, pose.y - side * x}}};
}

/// Thin beside the robot, but not too thin to see.
double outline_width(const wend::Footprint& footprint) {
  constexpr double kShare = 1.0 / 20;
  return std::clamp(kShare * footprint.circumscribed_radius(), 0.02, 0.1);
}

/// The poses between the ends of a path at which the robot changes between ahead and reverse.
std::vector<wend::Pose> gear_changes(const wend::Path& path) {
  std::vector<wend::Pose> changes;
  double before = 0;  // the length of the last segment that is not a turn in place
  const auto poses = path.driven_poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double length = wend::segment_between(poses[i - 1], poses[i]).length;
    if (length * before < 0) changes.push_back(poses[i - 1]);
    if (length != 0) before = length;
  }
  return changes;
}

Marker footprint_marker(const ShownPath& shown, const wend::Footprint& footprint) {
  Marker marker = marker_of(shown.frame_id, "footprint", Marker::LINE_LIST, kBlue);
  marker.scale.x = outline_width(footprint);
  std::vector<wend::Pose> poses;
  if (!shown.path.empty() && !footprint.is_point()) {
    poses =
        wend::outline_poses(shown.path, footprint.circumscribed_radius() / shown.frame.resolution);
    const auto changes = gear_changes(shown.path);
    poses.insert(poses.end() - 1, changes.begin(), changes.end());
  }
  for (std::size_t at = 0; at < poses.size(); ++at) {
    const wend::MapPose pose = shown.frame.to_metres(poses[at]);
    const auto outline = outline_at(footprint, pose);
    const auto colour = colour_of(at + 1 == poses.size() ? kOrange : at == 0 ? kGreen : kBlue);
    const auto add = [&](wend::MapPoint from, wend::MapPoint to) {
      marker.points.push_back(point_of(from, kThin));
      marker.points.push_back(point_of(to, kThin));
      marker.colors.insert(marker.colors.end(), 2, colour);
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
      add(outline[i], outline[(i + 1) % outline.size()]);
    }
    const auto chevron = chevron_in(outline, pose);
    add(chevron[0], chevron[1]);
    add(chevron[1], chevron[2]);
  }
  finish(marker);
  return marker;
}

Marker line_marker(const ShownPath& shown) {
  Marker marker = marker_of(shown.frame_id, "path", Marker::LINE_STRIP, kBlue);
  marker.scale.x = 0.04;
  if (!shown.path.empty()) {
    const wend::Polyline line = wend::polyline_of(shown.path);
    for (const wend::Point point : line.points()) {
      marker.points.push_back(point_of(shown.frame.to_metres(point), kThin));
    }
  }
  if (marker.points.size() < 2) marker.points.clear();  // one point is no line
  finish(marker);
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray yard_markers(const wend::GridMap& map,
                                             const std::string& frame_id) {
  const wend::Frame& frame = map.frame();
  Marker obstacles = marker_of(frame_id, "obstacles", Marker::CUBE_LIST, kRed);
  Marker rough = marker_of(frame_id, "rough", Marker::CUBE_LIST, kYellow);
  for (Marker* marker : {&obstacles, &rough}) {
    marker->scale.x = frame.resolution;
    marker->scale.y = frame.resolution;
    marker->scale.z = kThin;
    if (!frame.y_up) {
      marker->pose.orientation.w = 0;
      marker->pose.orientation.x = 1;
    }
  }
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const wend::Cell cell{x, y};
      auto point = point_of(frame.to_metres(wend::centre_of(cell)), 0);
      if (!frame.y_up) point.y = -point.y;
      if (map.state(cell) == wend::CellState::occupied) {
        obstacles.points.push_back(point);
      } else if (map.terrain(cell) > 1) {
        rough.points.push_back(point);
      }
    }
  }
  visualization_msgs::MarkerArray array;
  for (Marker* marker : {&obstacles, &rough}) {
    finish(*marker);
    array.markers.push_back(*marker);
  }
  return array;
}

visualization_msgs::MarkerArray path_markers(const ShownPath& shown,
                                             const wend::Footprint& footprint) {
  visualization_msgs::MarkerArray array;
  array.markers = {line_marker(shown), footprint_marker(shown, footprint)};
  if (shown.path.empty()) {
    for (const char* name : {"start", "goal"}) {
      Marker gone = marker_of(shown.frame_id, name, Marker::ARROW, kGreen);
      gone.action = Marker::DELETE;
      array.markers.push_back(gone);
    }
    return array;
  }
  const std::vector<wend::Pose> poses = shown.path.poses();
  const double length = arrow_length(footprint);
  const auto add = [&](const std::string& name, const wend::Pose& pose, const Rgb& colour) {
    array.markers.push_back(
        end_marker(shown.frame.to_metres(pose), shown.frame_id, name, colour, length));
  };
  add("start", poses.front(), kGreen);
  add("goal", poses.back(), kOrange);
  return array;
}

nav_msgs::OccupancyGrid heatmap_of(const std::vector<wend::Cell>& order, const wend::GridMap& map,
                                   const std::string& frame_id) {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = frame_id;
  grid.info = information_of(map);
  constexpr double kFirst = 1;
  constexpr double kLast = 98;
  grid.data.assign(map.size(), 0);
  const auto last = static_cast<double>(std::max<std::size_t>(order.size(), 2) - 1);
  for (std::size_t i = order.size(); i-- > 0;) {  // the first time that a cell was expanded counts
    const wend::Cell cell = order[i];
    if (!map.contains(cell)) continue;
    const int row = map.frame().y_up ? cell.y : map.height() - 1 - cell.y;
    grid.data[static_cast<std::size_t>(row) * grid.info.width + static_cast<std::size_t>(cell.x)] =
        static_cast<std::int8_t>(
            std::lround(kFirst + (kLast - kFirst) * static_cast<double>(i) / last));
  }
  return grid;
}

}  // namespace wend_ros
