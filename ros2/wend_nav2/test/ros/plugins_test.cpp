// SPDX-License-Identifier: Apache-2.0
//
// The plugins as Nav2's servers use them: loaded by pluginlib, on a Costmap2DROS.

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <nav2_core/global_planner.hpp>
#include <nav2_core/planner_exceptions.hpp>
#include <nav2_core/smoother.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <pluginlib/class_loader.hpp>
#include <rclcpp/rclcpp.hpp>

#include "../../src/nav2_types.hpp"

namespace wend_nav2 {
namespace {

using Pose = geometry_msgs::msg::PoseStamped;

class Plugins : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const char* arguments[] = {"plugins_test", "--ros-args",
                               "-p",           "plugins:=['inflation']",
                               "-p",           "inflation.plugin:=nav2_costmap_2d::InflationLayer",
                               "-p",           "width:=5",
                               "-p",           "height:=4",
                               "-p",           "resolution:=0.1",
                               "-p",           "robot_radius:=0.1"};
    rclcpp::init(static_cast<int>(std::size(arguments)), arguments);
    // One for all tests: its executor must spin before it can be stopped.
    costmap_ = std::make_shared<nav2_costmap_2d::Costmap2DROS>("global_costmap", "/",
                                                               "global_costmap", false);
    costmap_->configure();
  }
  static void TearDownTestSuite() {
    costmap_->cleanup();
    costmap_.reset();
    rclcpp::shutdown();
  }

  void SetUp() override {
    node_ = std::make_shared<Node>("planner_server");
    auto& costs = *costmap_->getCostmap();
    costs.resetMap(0, 0, costs.getSizeInCellsX(), costs.getSizeInCellsY());
  }

  std::shared_ptr<nav2_core::GlobalPlanner> planner(
      const std::vector<rclcpp::Parameter>& set = {}) {
    for (const rclcpp::Parameter& parameter : set) {
      node_->declare_parameter(parameter.get_name(), parameter.get_parameter_value());
    }
    std::shared_ptr<nav2_core::GlobalPlanner> made =
        loader_.createSharedInstance("wend_nav2::Planner");
    made->configure(node_, "wend", nullptr, costmap_);
    made->activate();
    return made;
  }

  static Pose pose(double x, double y) {
    Pose made;
    made.header.frame_id = "map";
    made.pose.position.x = x;
    made.pose.position.y = y;
    made.pose.orientation.w = 1;
    return made;
  }

  static nav_msgs::msg::Path plan(nav2_core::GlobalPlanner& planner, const Pose& start,
                                  const Pose& goal, bool cancelled = false) {
#if WEND_NAV2_VIAPOINTS
    return planner.createPlan(start, goal, {}, [cancelled] { return cancelled; });
#else
    return planner.createPlan(start, goal, [cancelled] { return cancelled; });
#endif
  }

  /// A wall across the costmap, but for its first `gap` rows.
  void build_wall(unsigned gap) {
    auto& costs = *costmap_->getCostmap();
    for (unsigned y = 0; y < costs.getSizeInCellsY(); ++y) costs.setCost(25, y, y < gap ? 0 : 254);
  }

  std::shared_ptr<Node> node_;
  static inline std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  pluginlib::ClassLoader<nav2_core::GlobalPlanner> loader_{"nav2_core", "nav2_core::GlobalPlanner"};
};

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

TEST(SmootherPlugin, IsFoundAndLoaded) {
  pluginlib::ClassLoader<nav2_core::Smoother> loader("nav2_core", "nav2_core::Smoother");
  EXPECT_TRUE(loader.isClassAvailable("wend_nav2::Smoother"));
  EXPECT_NE(loader.createSharedInstance("wend_nav2::Smoother"), nullptr);
}

}  // namespace
}  // namespace wend_nav2
