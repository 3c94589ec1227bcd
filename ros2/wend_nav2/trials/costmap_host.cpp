// SPDX-License-Identifier: Apache-2.0
#include "costmap_host.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <nav2_costmap_2d/cost_values.hpp>

namespace wend_nav2::trials {
namespace {

nav_msgs::msg::OccupancyGrid message_of(const wend::GridMap& map) {
  nav_msgs::msg::OccupancyGrid message;
  message.header.frame_id = "map";
  message.info.width = static_cast<unsigned>(map.width());
  message.info.height = static_cast<unsigned>(map.height());
  message.info.resolution = static_cast<float>(map.frame().resolution);
  message.info.origin.orientation.w = 1;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const wend::CellState state = map.state({x, y});
      message.data.push_back(state == wend::CellState::free       ? 0
                             : state == wend::CellState::occupied ? 100
                                                                  : -1);
    }
  }
  return message;
}

/// The robot stands in the middle of the map.
geometry_msgs::msg::TransformStamped place_of_robot(const wend::GridMap& map) {
  geometry_msgs::msg::TransformStamped place;
  place.header.frame_id = "map";
  place.child_frame_id = "base_link";
  place.transform.translation.x = map.width() * map.frame().resolution / 2;
  place.transform.translation.y = map.height() * map.frame().resolution / 2;
  place.transform.rotation.w = 1;
  return place;
}

}  // namespace

CostmapHost::CostmapHost(const wend::GridMap& map, double seconds)
    : node_(std::make_shared<nav2_util::LifecycleNode>("planner_server", "")),
      map_node_(std::make_shared<rclcpp::Node>("map_of_trials")),
      map_topic_(map_node_->create_publisher<nav_msgs::msg::OccupancyGrid>(
          "/map", rclcpp::QoS(1).transient_local().reliable())),
      robot_(std::make_unique<tf2_ros::StaticTransformBroadcaster>(map_node_)),
      costmap_(std::make_shared<nav2_costmap_2d::Costmap2DROS>("global_costmap", "/",
                                                               "global_costmap", false)) {
  map_topic_->publish(message_of(map));
  robot_->sendTransform(place_of_robot(map));
  costmap_->configure();
  costmap_thread_ = std::make_unique<nav2_util::NodeThread>(costmap_);
  costmap_->activate();
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!has(map)) {
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error("the costmap has no map");
    // Costmap2DROS has no call that waits for its map.
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  costmap_->pause();
}

CostmapHost::~CostmapHost() {
  costmap_->deactivate();
  costmap_->cleanup();
}

bool CostmapHost::has(const wend::GridMap& map) const {
  const auto& costs = *costmap_->getCostmap();
  if (!costmap_->isCurrent() || static_cast<int>(costs.getSizeInCellsX()) != map.width() ||
      static_cast<int>(costs.getSizeInCellsY()) != map.height()) {
    return false;
  }
  // The costmap has its size before it has its costs.
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (map.state({x, y}) != wend::CellState::occupied) continue;
      return costs.getCost(static_cast<unsigned>(x), static_cast<unsigned>(y)) ==
             nav2_costmap_2d::LETHAL_OBSTACLE;
    }
  }
  return true;
}

nav2_core::GlobalPlanner::Ptr CostmapHost::planner(const std::string& name,
                                                   const std::string& type) {
  nav2_core::GlobalPlanner::Ptr planner = loader_.createUniqueInstance(type);
  planner->configure(node_, name, costmap_->getTfBuffer(), costmap_);
  planner->activate();
  return planner;
}

}  // namespace wend_nav2::trials
