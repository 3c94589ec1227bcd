// SPDX-License-Identifier: Apache-2.0
#pragma once

// CostmapHost: what a planner server gives its planners, and no more: a lifecycle node, a Costmap2DROS that has taken
// a map from a topic, and planners that pluginlib has loaded.

#include <functional>
#include <memory>
#include <string>

#include <tf2_ros/static_transform_broadcaster.h>
#include <nav2_core/global_planner.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <nav2_util/lifecycle_node.hpp>
#include <nav2_util/node_thread.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <pluginlib/class_loader.hpp>

#include "wend/map/grid_map.hpp"

namespace wend_nav2::trials {

class CostmapHost {
 public:
  /// Publishes the map and waits until the costmap has it, then stops the costmap's updates. Throws if it does not
  /// come within `seconds`.
  explicit CostmapHost(const wend::GridMap& map, double seconds = 30);
  ~CostmapHost();

  /// Loads a planner by its class and configures it under this name.
  nav2_core::GlobalPlanner::Ptr planner(const std::string& name, const std::string& type);

  nav2_costmap_2d::Costmap2DROS& costmap_ros() { return *costmap_; }
  nav2_costmap_2d::Costmap2D& costmap() { return *costmap_->getCostmap(); }
  nav2_util::LifecycleNode& node() { return *node_; }

 private:
  bool has(const wend::GridMap& map) const;

  std::shared_ptr<nav2_util::LifecycleNode> node_;
  std::shared_ptr<rclcpp::Node> map_node_;
  rclcpp::Publisher<nav_msgs::msg::OccupancyGrid>::SharedPtr map_topic_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> robot_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  std::unique_ptr<nav2_util::NodeThread> costmap_thread_;
  pluginlib::ClassLoader<nav2_core::GlobalPlanner> loader_{"nav2_core", "nav2_core::GlobalPlanner"};
};

}  // namespace wend_nav2::trials
