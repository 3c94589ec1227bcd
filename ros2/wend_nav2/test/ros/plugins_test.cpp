// SPDX-License-Identifier: Apache-2.0
//
// The plugins as Nav2's servers use them: loaded by pluginlib, on a Costmap2DROS.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <tf2_ros/buffer.h>
#include <nav2_core/global_planner.hpp>
#include <nav2_core/planner_exceptions.hpp>
#include <nav2_core/smoother.hpp>
#include <nav2_core/smoother_exceptions.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <nav2_costmap_2d/costmap_subscriber.hpp>
#include <nav2_costmap_2d/footprint_subscriber.hpp>
#include <nav2_msgs/msg/costmap.hpp>
#include <pluginlib/class_loader.hpp>
#include <rclcpp/rclcpp.hpp>

#include "plugins_fixture.hpp"

namespace wend_nav2 {
namespace {

TEST_F(Plugins, ThePlannerIsLoadedAndPlans) {
  const auto made = planner();
  build_wall(3);
  const auto path = plan(*made, pose(0.52, 3.03), pose(4.55, 3.05));
  ASSERT_GT(path.poses.size(), 60U);
  EXPECT_EQ(path.header.frame_id, "map");
  EXPECT_DOUBLE_EQ(path.poses.front().pose.position.x, 0.52);
  EXPECT_DOUBLE_EQ(path.poses.back().pose.position.x, 4.55);
  EXPECT_LT(std::min_element(
                path.poses.begin(), path.poses.end(),
                [](const Pose& a, const Pose& b) { return a.pose.position.y < b.pose.position.y; })
                ->pose.position.y,
            0.3);
}

TEST_F(Plugins, FailuresAreNav2sExceptions) {
  const auto made = planner({{"wend.tolerance", 0.0}});
  build_wall(0);
  const Pose left = pose(0.5, 2);
  EXPECT_THROW(plan(*made, left, pose(4.5, 2)), nav2_core::NoValidPathCouldBeFound);
  EXPECT_THROW(plan(*made, pose(2.55, 2), left), nav2_core::StartOccupied);
  EXPECT_THROW(plan(*made, left, pose(2.55, 2)), nav2_core::GoalOccupied);
  EXPECT_THROW(plan(*made, pose(-1, 0), left), nav2_core::StartOutsideMapBounds);
  EXPECT_THROW(plan(*made, left, pose(9, 0)), nav2_core::GoalOutsideMapBounds);
  EXPECT_THROW(plan(*made, left, pose(1.5, 2), true), nav2_core::PlannerCancelled);
  Pose elsewhere = left;
  elsewhere.header.frame_id = "odom";
  EXPECT_THROW(plan(*made, elsewhere, left), nav2_core::PlannerTFError);
  node_->set_parameter({"wend.time_limit", 1e-9});
  EXPECT_THROW(plan(*made, left, pose(1.5, 2)), nav2_core::PlannerTimedOut);
}

TEST_F(Plugins, RefusesOrientationsThatAreNone) {
  const auto made = planner();
  const Pose left = pose(0.5, 2);
  for (const auto& [x, z, w] : {std::tuple{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}}) {
    Pose goal = pose(1.5, 2);
    goal.pose.orientation.x = x;
    goal.pose.orientation.z = z;
    goal.pose.orientation.w = w;
    EXPECT_THROW(plan(*made, left, goal), nav2_core::PlannerException);
    EXPECT_THROW(plan(*made, goal, left), nav2_core::PlannerException);
  }
}

TEST_F(Plugins, ACarNeedsATurningRadius) {
  const auto made = planner({{"wend.planner", "hybrid_astar"}});
  EXPECT_FALSE(node_->set_parameter({"wend.turning_radius", 0.0}).successful);
  EXPECT_FALSE(node_->set_parameter({"wend.turning_radius", std::nan("")}).successful);
  EXPECT_TRUE(node_->set_parameter({"wend.turning_radius", 0.5}).successful);
}

TEST_F(Plugins, SeesWhatTheCostmapHasNow) {
  const auto made = planner({{"wend.tolerance", 0.0}});
  for (int n = 0; n < 4; ++n) {
    build_wall(0);
    EXPECT_THROW(plan(*made, pose(0.5, 2), pose(4.5, 2)), nav2_core::NoValidPathCouldBeFound);
    build_wall(3);
    EXPECT_FALSE(plan(*made, pose(0.5, 2), pose(4.5, 2)).poses.empty());
  }
}

TEST_F(Plugins, ParametersHaveRangesAndChangeWhileItRuns) {
  const auto made = planner();
  EXPECT_FALSE(node_->set_parameter({"wend.weight", -1.0}).successful);
  EXPECT_FALSE(node_->set_parameter({"wend.connectivity", "6"}).successful);
  EXPECT_FALSE(node_->set_parameter({"wend.planner", "jps"}).successful);
  EXPECT_TRUE(node_->set_parameter({"wend.weight", 2}).successful) << "a whole number";
  EXPECT_TRUE(node_->set_parameter({"wend.connectivity", 4}).successful);
  EXPECT_TRUE(node_->set_parameter({"wend.smooth", false}).successful);
  const auto path = plan(*made, pose(0.55, 0.55), pose(2.55, 2.55));
  EXPECT_EQ(path.poses.size(), 41U) << "20 + 20 steps to four neighbours";
}

TEST_F(Plugins, AWrongParameterStopsTheServerFromConfiguring) {
  EXPECT_THROW(planner({{"wend.planner", "no_such"}}), std::runtime_error);
  node_ = std::make_shared<Node>("another_server");
  EXPECT_THROW(planner({{"wend.obstacles", "none"}}), std::runtime_error);
}

TEST_F(Plugins, CanBeConfiguredAgainAfterCleanup) {
  const auto made = planner();
  made->deactivate();
  made->cleanup();
  EXPECT_THROW(plan(*made, pose(1, 1), pose(2, 2)), nav2_core::PlannerException);
  made->configure(node_, "wend", nullptr, costmap_);
  made->activate();
  EXPECT_FALSE(plan(*made, pose(1, 1), pose(2, 2)).poses.empty());
}

/// What the smoother server gives its smoothers: a costmap and a footprint from topics.
class SmootherPlugin : public Plugins {
 protected:
  SmootherPlugin() {
    geometry_msgs::msg::TransformStamped place;
    place.header.frame_id = "map";
    place.child_frame_id = "base_link";
    place.transform.rotation.w = 1;
    transforms_->setUsingDedicatedThread(true);
    transforms_->setTransform(place, "test", true);
    publish();
    made_->configure(node_of_smoother_, "safe", transforms_, costs_, footprint_);
    made_->activate();
  }

  void publish() {
    nav2_msgs::msg::Costmap costs;
    costs.header.frame_id = "map";
    costs.metadata.size_x = costs.metadata.size_y = 40;
    costs.metadata.resolution = 0.1f;
    costs.data.assign(1600, 0);
    costs.data[20 * 40 + 10] = 254;
    costs_topic_->publish(costs);
    geometry_msgs::msg::PolygonStamped footprint;
    footprint.header.frame_id = "map";
    for (int i = 0; i < 16; ++i) {
      auto& corner = footprint.polygon.points.emplace_back();
      corner.x = static_cast<float>(0.1 * std::cos(i * M_PI / 8));
      corner.y = static_cast<float>(0.1 * std::sin(i * M_PI / 8));
    }
    footprint_topic_->publish(footprint);
    for (int i = 0; i < 100 && !has_both(); ++i) {
      rclcpp::spin_some(node_of_topics_);
      // The subscribers of Nav2 have no call that waits for a message.
      rclcpp::sleep_for(std::chrono::milliseconds(20));
    }
    ASSERT_TRUE(has_both());
  }

  bool has_both() {
    std::vector<geometry_msgs::msg::Point> corners;
    std_msgs::msg::Header header;
    try {
      return costs_->getCostmap() && footprint_->getFootprintInRobotFrame(corners, header);
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  static nav_msgs::msg::Path corner_path(double y) {
    nav_msgs::msg::Path path;
    path.header.frame_id = "map";
    for (int i = 0; i <= 20; ++i) path.poses.push_back(pose(0.5 + 0.1 * i, y));
    for (int i = 1; i <= 15; ++i) path.poses.push_back(pose(2.5, y + 0.1 * i));
    return path;
  }

  std::shared_ptr<rclcpp::Node> node_of_topics_ = std::make_shared<rclcpp::Node>("topics");
  std::shared_ptr<Node> node_of_smoother_ = std::make_shared<Node>("smoother_server");
  rclcpp::QoS latched_ = rclcpp::QoS(1).transient_local().reliable();
  rclcpp::Publisher<nav2_msgs::msg::Costmap>::SharedPtr costs_topic_ =
      node_of_topics_->create_publisher<nav2_msgs::msg::Costmap>("costs_raw", latched_);
  rclcpp::Publisher<geometry_msgs::msg::PolygonStamped>::SharedPtr footprint_topic_ =
      node_of_topics_->create_publisher<geometry_msgs::msg::PolygonStamped>("footprint", 1);
  std::shared_ptr<tf2_ros::Buffer> transforms_ =
      std::make_shared<tf2_ros::Buffer>(node_of_topics_->get_clock());
  std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costs_ =
      std::make_shared<nav2_costmap_2d::CostmapSubscriber>(node_of_topics_, "costs_raw");
  std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_ =
      std::make_shared<nav2_costmap_2d::FootprintSubscriber>(node_of_topics_, "footprint",
                                                             *transforms_, "base_link", 10.0);
  pluginlib::ClassLoader<nav2_core::Smoother> smoothers_{"nav2_core", "nav2_core::Smoother"};
  std::shared_ptr<nav2_core::Smoother> made_ =
      smoothers_.createSharedInstance("wend_nav2::Smoother");
};

TEST_F(SmootherPlugin, RoundsACornerAndKeepsTheEnds) {
  auto path = corner_path(0.55);
  const auto before = path;
  EXPECT_TRUE(made_->smooth(path, rclcpp::Duration::from_seconds(5)));
  EXPECT_EQ(path.poses.front().pose, before.poses.front().pose);
  EXPECT_EQ(path.poses.back().pose, before.poses.back().pose);
  EXPECT_GT(path.poses[20].pose.position.y, 0.56) << "the corner is cut";
}

TEST_F(SmootherPlugin, RefusesAPathThroughAnObstacle) {
  auto path = corner_path(2.05);
  EXPECT_THROW(made_->smooth(path, rclcpp::Duration::from_seconds(5)), nav2_core::InvalidPath);
}

TEST_F(SmootherPlugin, RefusesWhatIsNotFiniteOrAbsurd) {
  for (const double number : {std::nan(""), double{INFINITY}, 1e300, 1e10}) {
    auto path = corner_path(0.55);
    path.poses[7].pose.position.x = number;
    EXPECT_THROW(made_->smooth(path, rclcpp::Duration::from_seconds(5)), nav2_core::InvalidPath);
  }
  auto path = corner_path(0.55);
  path.poses[7].pose.orientation.w = 0;
  EXPECT_THROW(made_->smooth(path, rclcpp::Duration::from_seconds(5)), nav2_core::InvalidPath);
}

TEST_F(SmootherPlugin, SaysThatItHadNoTime) {
  auto path = corner_path(0.55);
  EXPECT_FALSE(made_->smooth(path, rclcpp::Duration::from_seconds(-1)));
  EXPECT_EQ(path.poses.size(), corner_path(0.55).poses.size());
}

}  // namespace
}  // namespace wend_nav2
