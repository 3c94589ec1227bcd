#include "wend_ros/markers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wend_ros {
namespace {

using visualization_msgs::Marker;

nav_msgs::Path path_through(const std::vector<wend::MapPoint>& points) {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  for (const wend::MapPoint point : points) {
    geometry_msgs::PoseStamped stamped;
    stamped.pose.position.x = point.x;
    stamped.pose.position.y = point.y;
    stamped.pose.orientation.w = 1;
    path.poses.push_back(stamped);
  }
  return path;
}

Marker footprint_of(const visualization_msgs::MarkerArray& array) {
  const auto marker = std::find_if(array.markers.begin(), array.markers.end(),
                                   [](const Marker& any) { return any.ns == "footprint"; });
  return marker == array.markers.end() ? Marker() : *marker;
}

TEST(PathMarkers, ShowAPolygonFacingAlongThePath) {
  const auto robot = wend::parse_footprint("0.5,0.25;-0.5,0.25;-0.5,-0.25;0.5,-0.25");
  ASSERT_TRUE(robot);
  const Marker marker = footprint_of(path_markers(path_through({{1, 1}, {1, 2}}), *robot));
  EXPECT_EQ(marker.action, Marker::ADD);
  EXPECT_EQ(marker.header.frame_id, "map");
  ASSERT_EQ(marker.points.size(), 2 * 4 * 2U) << "four edges at the start and at the goal";
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(std::abs(marker.points[i].x - 1), 0.25, 1e-9) << "turned to +y";
    EXPECT_NEAR(std::abs(marker.points[i].y - 1), 0.5, 1e-9);
  }
}

TEST(PathMarkers, ShowADiscAsACircle) {
  const Marker marker =
      footprint_of(path_markers(path_through({{0, 0}, {5, 0}}), wend::Footprint::disc(0.5)));
  ASSERT_FALSE(marker.points.empty());
  for (std::size_t i = 0; i < 48; ++i) {
    EXPECT_NEAR(std::hypot(marker.points[i].x, marker.points[i].y), 0.5, 1e-9);
  }
}

TEST(PathMarkers, StayFewOnALongPath) {
  const Marker marker =
      footprint_of(path_markers(path_through({{0, 0}, {1e5, 0}}), wend::Footprint::disc(0.01)));
  EXPECT_LE(marker.points.size(), 202U * 48U);
}

TEST(PathMarkers, DeleteTheFootprintOfAPointAndOfAnEmptyPath) {
  EXPECT_EQ(footprint_of(path_markers(path_through({{0, 0}, {5, 0}}), {})).action, Marker::DELETE);
  EXPECT_EQ(footprint_of(path_markers(path_through({}), wend::Footprint::disc(1))).action,
            Marker::DELETE);
}

}  // namespace
}  // namespace wend_ros
