// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/robot_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace wend_nav2 {
namespace {

std::vector<wend::MapPoint> circle_of(int corners, double radius) {
  std::vector<wend::MapPoint> circle;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    circle.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return circle;
}

const std::vector<wend::MapPoint> kBox{{0.4, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.4, -0.2}};

TEST(RobotShape, TheCornersThatNav2PublishesForARadiusAreADisc) {
  const auto round = footprint_from(circle_of(16, 0.22));
  ASSERT_TRUE(round) << round.error().message;
  EXPECT_EQ(round->outline(), nullptr);
  EXPECT_NEAR(round->circumscribed_radius(), 0.22, 1e-12);
}

TEST(RobotShape, OtherCornersAreAPolygon) {
  EXPECT_NE(footprint_from(circle_of(8, 0.22))->outline(), nullptr);
  EXPECT_NE(footprint_from(kBox)->outline(), nullptr);
  EXPECT_FALSE(footprint_from(std::vector<wend::MapPoint>{{1, 1}, {2, 2}}));
}

TEST(RobotShape, MayHaveItsOriginOutside) {
  const auto fork = footprint_from(std::vector<wend::MapPoint>{
      {0.9, 0.2}, {0.1, 0.2}, {0.1, 0.2}, {0.1, -0.2}, {0.9, -0.2}, {0.9, 0.2}});
  ASSERT_TRUE(fork) << fork.error().message;
  EXPECT_FALSE(fork->covers_base_point());
  EXPECT_EQ(fork->outline()->corners().size(), 4);
}

TEST(RobotShape, IsReadFromText) {
  EXPECT_EQ(*footprint_from("[[0.4, 0.2], [-0.3, 0.2], [-0.3, -0.2], [0.4, -0.2]]"),
            *footprint_from(kBox));
  EXPECT_EQ(*footprint_from("rect:0.75x0.5,0.125"), *wend::Footprint::rectangle(0.75, 0.5, 0.125));
  EXPECT_FALSE(footprint_from("rect:0.7"));
}

TEST(RobotShape, OnlyTheRuleInscribedMakesARobotAPoint) {
  const RobotShape box{*footprint_from(kBox), true};
  EXPECT_EQ(rule_for(ObstacleRule::automatic), ObstacleRule::footprint);
  EXPECT_EQ(rule_for(ObstacleRule::inscribed), ObstacleRule::inscribed);
  EXPECT_EQ(rule_for(ObstacleRule::footprint), ObstacleRule::footprint);
  EXPECT_TRUE(robot_for(ObstacleRule::inscribed, box, true).footprint.is_point());
  EXPECT_EQ(robot_for(ObstacleRule::footprint, box, true).footprint, box.footprint);
  EXPECT_TRUE(scale_for(ObstacleRule::inscribed, 4).inscribed_blocked);
  EXPECT_FALSE(scale_for(ObstacleRule::footprint, 4).inscribed_blocked);
}

TEST(RobotShape, UnknownCellsAreWhatTheParameterSays) {
  const RobotShape round{wend::Footprint::disc(0.2), true};
  EXPECT_EQ(robot_for(ObstacleRule::inscribed, round, true).unknown, wend::UnknownPolicy::free);
  EXPECT_EQ(robot_for(ObstacleRule::inscribed, round, false).unknown, wend::UnknownPolicy::blocked);
}

}  // namespace
}  // namespace wend_nav2
