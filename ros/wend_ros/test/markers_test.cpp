#include "wend_ros/markers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "wend/geometry/angle.hpp"

namespace wend_ros {
namespace {

using visualization_msgs::Marker;

/// Of a path in cells of 0.5 m.
visualization_msgs::MarkerArray shown(const wend::Path& path, const wend::Footprint& footprint) {
  return path_markers({path, {.resolution = 0.5}, "map"}, footprint);
}

wend::Path line(wend::Point from, wend::Point to) { return wend::Path::along({from, to}); }

Marker footprint_of(const visualization_msgs::MarkerArray& array) {
  const auto marker = std::find_if(array.markers.begin(), array.markers.end(),
                                   [](const Marker& any) { return any.ns == "footprint"; });
  return marker == array.markers.end() ? Marker() : *marker;
}

wend::Footprint box() { return *wend::parse_footprint("0.5,0.25;-0.5,0.25;-0.5,-0.25;0.5,-0.25"); }

constexpr std::size_t kOfABox = 12;  // points: four edges, and a chevron
constexpr std::size_t kOfADisc = 52;

/// Is the i-th outline of a marker that of the box at this place, along x or along y?
void expect_box(const Marker& marker, std::size_t i, wend::MapPoint at, bool along_y) {
  const std::size_t first = kOfABox * i;
  ASSERT_GE(marker.points.size(), first + kOfABox);
  EXPECT_NEAR(marker.points[first + 9].x, at.x + (along_y ? 0 : 0.5), 1e-9) << "the front";
  EXPECT_NEAR(marker.points[first + 9].y, at.y + (along_y ? 0.5 : 0), 1e-9);
  for (std::size_t corner = first; corner < first + 8; ++corner) {
    EXPECT_NEAR(std::abs(marker.points[corner].x - at.x), along_y ? 0.25 : 0.5, 1e-9);
    EXPECT_NEAR(std::abs(marker.points[corner].y - at.y), along_y ? 0.5 : 0.25, 1e-9);
  }
}

TEST(PathMarkers, ShowAPolygonFacingAlongThePath) {
  const Marker marker = footprint_of(shown(line({2, 2}, {2, 4}), box()));
  EXPECT_EQ(marker.action, Marker::ADD);
  EXPECT_EQ(marker.header.frame_id, "map");
  ASSERT_EQ(marker.points.size(), 2 * kOfABox) << "at the start and at the goal";
  expect_box(marker, 0, {1, 1}, true);
  expect_box(marker, 1, {1, 2}, true);
}

TEST(PathMarkers, ShowAPolygonAsItFacesOnPathsOfPoses) {
  const double up = wend::kPi / 2;
  const auto aside = wend::Path::through({{0, 0, 0}, {0, 16, 0}});
  const Marker sideways = footprint_of(shown(aside, box()));
  ASSERT_GE(sideways.points.size(), 3 * kOfABox);
  for (std::size_t i = 0; kOfABox * i < sideways.points.size(); ++i) {
    const double y = sideways.points[kOfABox * i + 9].y;
    EXPECT_NEAR(y, 8.0 * static_cast<double>(i) / (sideways.points.size() / kOfABox - 1), 1e-6);
    expect_box(sideways, i, {0, y}, false);
  }
  const Marker turning = footprint_of(shown(wend::Path::through({{2, 2, 0}, {2, 2, up}}), box()));
  ASSERT_EQ(turning.points.size(), 2 * kOfABox);
  expect_box(turning, 0, {1, 1}, false);
  expect_box(turning, 1, {1, 1}, true);
}

TEST(PathMarkers, ShowAPolygonWhereItChangesGear) {
  const auto shunting = wend::Path::through({{2, 2, 0}, {3, 2, 0}, {4, 2, 0}, {3, 2, 0}});
  const Marker marker = footprint_of(shown(shunting, box()));
  ASSERT_EQ(marker.points.size(), 3 * kOfABox);
  expect_box(marker, 0, {1, 1}, false);
  expect_box(marker, 1, {2, 1}, false);
  expect_box(marker, 2, {1.5, 1}, false);
}

TEST(PathMarkers, PointTheWayTheRobotFacesAtItsEnds) {
  const auto array =
      shown(wend::Path::through({{0, 0, 0}, {-4, 0, 0}, {-4, 0, wend::kPi / 2}}), box());
  for (const Marker& marker : array.markers) {
    const double turned = marker.pose.orientation.z;
    if (marker.ns == "start") {
      EXPECT_NEAR(turned, 0, 1e-9) << "it backs away";
    }
    if (marker.ns == "goal") {
      EXPECT_NEAR(turned, std::sin(wend::kPi / 4), 1e-9);
    }
  }
}

TEST(PathMarkers, HaveArrowsAsLongAsTheRobot) {
  const auto length = [](const wend::Footprint& footprint) {
    return shown(line({0, 0}, {16, 0}), footprint).markers.back().scale.x;
  };
  EXPECT_EQ(length({}), 0.5);
  EXPECT_EQ(length(wend::Footprint::disc(0.9)), 0.9);
  EXPECT_EQ(length(wend::Footprint::disc(0.01)), 0.2) << "still to be seen";
}

TEST(PathMarkers, HaveTheColoursOfTheStartAndTheGoalAtTheirOutlines) {
  const Marker marker = footprint_of(shown(line({0, 0}, {16, 0}), box()));
  ASSERT_EQ(marker.colors.size(), marker.points.size()) << "one a point, or rviz refuses them";
  EXPECT_NE(marker.colors.front(), marker.colors.back());
  EXPECT_NE(marker.colors.front(), marker.colors[kOfABox]);
}

TEST(PathMarkers, FollowTheArcsOfAPath) {
  const auto quarter = wend::Path::through({{0, 0, 0}, {8, 8, wend::kPi / 2}});
  const Marker curve = shown(quarter, {}).markers.front();
  ASSERT_GT(curve.points.size(), 5U);
  for (const auto& point : curve.points) EXPECT_NEAR(std::hypot(point.x, point.y - 4), 4, 0.01);
}

TEST(PathMarkers, ShowADiscAsACircle) {
  const Marker marker = footprint_of(shown(line({0, 0}, {10, 0}), wend::Footprint::disc(0.5)));
  ASSERT_FALSE(marker.points.empty());
  for (std::size_t i = 0; i < 48; ++i) {
    EXPECT_NEAR(std::hypot(marker.points[i].x, marker.points[i].y), 0.5, 1e-9);
  }
}

TEST(PathMarkers, StayFewOnALongPath) {
  const Marker marker = footprint_of(shown(line({0, 0}, {2e5, 0}), wend::Footprint::disc(0.01)));
  EXPECT_LE(marker.points.size(), 201 * kOfADisc);
}

TEST(PathMarkers, DeleteTheFootprintOfAPointAndOfAnEmptyPath) {
  EXPECT_EQ(footprint_of(shown(line({0, 0}, {5, 0}), {})).action, Marker::DELETE);
  EXPECT_EQ(footprint_of(shown({}, wend::Footprint::disc(1))).action, Marker::DELETE);
}

}  // namespace
}  // namespace wend_ros
