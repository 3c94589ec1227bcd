// The Stanley controller, by its maker in the registry.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "wend/control/controller.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kStep = 0.02;  // s

struct Errors {
  double aside = 0;    // m
  double heading = 0;  // rad
};

/// Drives along a line by exact arcs, from its beginning moved aside and turned; the errors after a time.
Errors errors_after(double seconds, const MapPolyline& line, double aside, double turned) {
  const auto controller = make_controller("stanley").value();
  const VelocityLimits limits;
  controller->begin(line, limits);
  const MapPose start = line.at(0);
  MapPose pose{start.x - aside * std::sin(start.heading), start.y + aside * std::cos(start.heading),
               start.heading + turned};
  double along = 0;
  for (double time = 0; time < seconds; time += kStep) {
    along = line.nearest(pose.point(), along, along + 1).along;
    const Velocity wanted = controller->command({pose, {}, &line, along, 1, kStep, limits});
    pose = hold(pose, wanted, kStep).to.pose;
  }
  const OnMapPolyline place = line.nearest(pose.point(), along, along + 1);
  return {place.distance, normalized_angle(line.heading_at(place.along, 0.1) - pose.heading)};
}

/// A circle to the left, in chords of 2 degrees.
MapPolyline circle(double radius) {
  std::vector<MapPoint> points;
  for (int i = 0; i <= 180; ++i) {
    const double angle = radians_from(2 * i);
    points.push_back({radius * std::sin(angle), radius * (1 - std::cos(angle))});
  }
  return MapPolyline(points);
}

TEST(Stanley, ComesBackToALineFromBothSides) {
  const MapPolyline line(std::vector<MapPoint>{{0, 0}, {20, 0}});
  for (const double aside : {-0.3, 0.1, 0.3}) {
    for (const double turned : {-1.0, 0.0, 1.0}) {
      const Errors errors = errors_after(12, line, aside, turned);
      EXPECT_LT(errors.aside, 0.005) << aside << ' ' << turned;
      EXPECT_NEAR(errors.heading, 0, 0.01) << aside << ' ' << turned;
    }
  }
}

TEST(Stanley, HasNoLastingErrorInABend) {
  // A wheel that followed the path itself would draw the base point 0.041 m inwards.
  const Errors errors = errors_after(5, circle(0.5), 0.05, 0);
  EXPECT_LT(errors.aside, 0.005);
  EXPECT_NEAR(errors.heading, 0, 0.03);
}

TEST(Stanley, TurnsInPlaceWhereTheFollowerAsksForIt) {
  const MapPolyline line(std::vector<MapPoint>{{0, 0}, {1, 0}});
  const auto controller = make_controller("stanley").value();
  controller->begin(line, {});
  const MapPose pose{0, 0, -1};
  const Velocity wanted = controller->command({pose, {}, &line, 0, 1, kStep, {}, false, 1.0});
  EXPECT_EQ(wanted.linear, 0);
  EXPECT_GT(wanted.angular, 0);
}

}  // namespace
}  // namespace wend
