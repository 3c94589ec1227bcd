#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "tests/testing/c_objects.hpp"
#include "wend/c/objects.hpp"

namespace wend::test {
namespace {

constexpr std::array<wend_point, 4> kBox{
    wend_point{0.4, 0.25}, {0.4, -0.25}, {-0.3, -0.25}, {-0.3, 0.25}};

Owned<wend_robot> made_robot(const wend_robot_options& options) {
  return made_object<wend_robot>([&](wend_robot** robot, wend_error* error) {
    return wend_robot_create(&options, robot, error);
  });
}

Refusal refused_robot(const wend_robot_options& options) {
  return refusal_of<wend_robot>([&](wend_robot** robot, wend_error* error) {
    return wend_robot_create(&options, robot, error);
  });
}

TEST(CRobot, IsAPointADiscOrAPolygon) {
  wend_robot_options options = robot_options();
  EXPECT_EQ(made_robot(options)->robot, Robot{});
  options.radius = 0.2;
  options.clearance_distance = 0.5;
  options.clearance_cost = 3;
  EXPECT_EQ(made_robot(options)->robot, (Robot{Footprint::disc(0.2), 0.5, 3}));
  options.radius = 0;
  options.corners = kBox.data();
  options.corner_count = kBox.size();
  EXPECT_EQ(made_robot(options)->robot.footprint,
            parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25").value());
}

TEST(CRobot, IsReadFromText) {
  wend_robot_options options = robot_options();
  options.footprint = "rect:0.8x0.4,0.6";
  EXPECT_EQ(made_robot(options)->robot.footprint, *Footprint::rectangle(0.8, 0.4, 0.6));
  options.footprint = "rect:0.8";
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
  options.footprint = "disc:0.2";
  options.radius = 0.2;
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_ARGUMENT);
}

TEST(CRobot, MayHaveItsBasePointOutsideItsCorners) {
  wend_robot_options options = robot_options();
  std::array<wend_point, 4> corners = kBox;
  for (wend_point& corner : corners) corner.x += 10;
  options.corners = corners.data();
  options.corner_count = corners.size();
  EXPECT_FALSE(made_robot(options)->robot.footprint.covers_base_point());
}

TEST(CRobot, RefusesNumbersOutOfRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double number : {-1.0, kAnyHeading, kInfinity}) {
    wend_robot_options options = robot_options();
    options.radius = number;
    EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
    options = robot_options();
    options.clearance_distance = number;
    EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
    options = robot_options();
    options.clearance_cost = number;
    EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
  }
}

TEST(CRobot, RefusesCornersThatAreNotAPolygon) {
  wend_robot_options options = robot_options();
  options.corner_count = 4;
  EXPECT_EQ(refused_robot(options).message,
            "wend_robot_options.corners is null, but corner_count is not 0");
  options.corners = kBox.data();
  options.radius = 1;
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_ARGUMENT);
  options.radius = 0;
  options.corner_count = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_ARGUMENT);
  options.corner_count = 2;
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
  std::array<wend_point, 4> corners = kBox;
  std::swap(corners[0], corners[1]);  // its edges cross
  options.corners = corners.data();
  options.corner_count = 4;
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
  corners = kBox;
  corners[1].y = kAnyHeading;
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_OPTION);
}

TEST(CRobot, RefusesNullPointersAndOtherStructures) {
  const auto null = refusal_of<wend_robot>([](wend_robot** robot, wend_error* error) {
    return wend_robot_create(nullptr, robot, error);
  });
  EXPECT_EQ(null.message, "options is null");
  wend_robot_options options = robot_options();
  EXPECT_EQ(wend_robot_create(&options, nullptr, nullptr), WEND_INVALID_ARGUMENT);
  options.struct_size = 0;
  EXPECT_EQ(refused_robot(options).status, WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_robot_options_init(nullptr, sizeof options), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_robot_options_init(&options, 1), WEND_INVALID_ARGUMENT);
  wend_robot_free(nullptr);
}

}  // namespace
}  // namespace wend::test
