// SPDX-License-Identifier: Apache-2.0
#include "wend_ros/node_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace wend_ros {
namespace {

using testing::HasSubstr;

std::string fault_of(const NodeSettings& settings) {
  const auto robot = robot_from(settings);
  return robot ? "none" : robot.error().message;
}

TEST(NodeSettings, TheRobotIsADiscOrThePolygonOfItsCorners) {
  EXPECT_EQ(*robot_from({}), wend::Footprint::disc(0.2));
  EXPECT_TRUE(robot_from({.robot_radius = 0})->is_point());
  const auto box = robot_from({.footprint = {1, 1, -1, 1, -1, -1, 1, -1}});
  ASSERT_TRUE(box) << box.error().message;
  EXPECT_NE(box->outline(), nullptr);
  EXPECT_EQ(*robot_from({.shape = "rect:2x2"}), *wend::Footprint::rectangle(2, 2));
}

TEST(NodeSettings, WhatIsWrongIsRefusedByItsName) {
  for (const double radius : {-1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    EXPECT_THAT(fault_of({.robot_radius = radius}), HasSubstr("robot_radius"));
  }
  EXPECT_THAT(fault_of({.footprint = {1, 1, -1}}), HasSubstr("even count"));
  EXPECT_THAT(fault_of({.footprint = {1, 1, -1, 1}}), HasSubstr("footprint"));
  EXPECT_THAT(fault_of({.footprint = {1, 1, std::nan(""), 1, -1, -1}}), HasSubstr("footprint"));
  EXPECT_THAT(fault_of({.shape = "rect:2"}), HasSubstr("footprint"));
  for (const std::int64_t value : {0, 101, -5}) {
    EXPECT_THAT(fault_of({.occupied_from = value}), HasSubstr("1..100"));
  }
  EXPECT_THAT(fault_of({.robot_frame = ""}), HasSubstr("robot_frame"));
}

}  // namespace
}  // namespace wend_ros
