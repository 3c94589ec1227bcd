// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the tests of all plugins have: a costmap of 5 m x 4 m for a robot of 0.1 m, and a node.

#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav2_core/global_planner.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <pluginlib/class_loader.hpp>
#include <rclcpp/rclcpp.hpp>

#include "../../src/nav2_types.hpp"

namespace wend_nav2 {

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

}  // namespace wend_nav2
