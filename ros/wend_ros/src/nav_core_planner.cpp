// wend's planners for move_base: a nav_core::BaseGlobalPlanner. Built where nav_core and costmap_2d are
// found, which Debian does not have.
//
//   <param name="base_global_planner" value="wend_ros/NavCorePlanner"/>
//   <param name="NavCorePlanner/planner" value="astar"/>
//
// Its parameters are those of planner_server, below the plugin's name.

#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/base_global_planner.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <string>
#include <vector>

#include "wend_ros/costmap.hpp"
#include "wend_ros/option_parameters.hpp"
#include "wend_ros/planning.hpp"
#include "wend_ros/plugins.hpp"
#include "wend_ros/pose_message.hpp"

namespace wend_ros {

class NavCorePlanner final : public nav_core::BaseGlobalPlanner {
 public:
  void initialize(std::string name, costmap_2d::Costmap2DROS* costmap) override {
    const ros::NodeHandle own("~/" + name);
    if (const std::string fault = load_plugins(own); !fault.empty()) {
      ROS_FATAL_STREAM(name << ": " << fault);
      return;
    }
    parameters_ = Parameters();  // with the options of the planners that were loaded
    for (const auto& [option, value] : parameters_of(own, parameters_.schema())) {
      const std::string fault = parameters_.set(option, value);
      if (!fault.empty()) ROS_ERROR_STREAM(name << ": " << fault);
    }
    costmap_ = costmap;
  }

  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan) override {
    double cost = 0;
    return makePlan(start, goal, plan, cost);
  }

  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan, double& cost) override {
    plan.clear();
    if (costmap_ == nullptr) {
      ROS_ERROR("makePlan() before initialize()");
      return false;
    }
    const auto from = pose_from(start.pose);
    const auto to = pose_from(goal.pose);
    if (!from || !to) {
      ROS_ERROR_STREAM((from ? "the goal " : "the start ") << (from ? to : from).error());
      return false;
    }
    take_costmap();
    const auto map = session_.view();
    if (!map) {
      ROS_ERROR_STREAM(map.error().message);
      return false;
    }
    for (const auto* pose : {&start, &goal}) {
      if (pose->header.frame_id == map->frame_id) continue;
      ROS_ERROR_STREAM("a pose in the frame '" << pose->header.frame_id << "', '" << map->frame_id
                                               << "' expected");
      return false;
    }
    const Ask ask{.start = *from,
                  .goals = {*to},
                  .planner = {},
                  .options = {},
                  .keep = parameters_.number("keep")};
    const auto [result, path, driven, way] = answer(session_, *map, parameters_, ask);
    if (result.status != static_cast<std::uint16_t>(StatusCode::found)) {
      ROS_WARN_STREAM(result.status_name << ": " << result.reason);
      return false;
    }
    const bool smooth = !result.smoothed.poses.empty();
    plan = smooth ? result.smoothed.poses : way.poses;
    for (auto& pose : plan) pose.header.stamp = ros::Time::now();
    plan.back().pose.orientation = goal.pose.orientation;
    cost = result.cost;
    return true;
  }

 private:
  /// The costmap as it is now: every plan has a map of its own.
  void take_costmap() {
    costmap_2d::Costmap2D& costs = *costmap_->getCostmap();
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costs.getMutex());
    const auto width = static_cast<int>(costs.getSizeInCellsX());
    const auto height = static_cast<int>(costs.getSizeInCellsY());
    const std::span<const std::uint8_t> values(
        costs.getCharMap(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    auto map =
        map_from_costs(values, width, height, costs.getResolution(),
                       {costs.getOriginX(), costs.getOriginY()}, parameters_.number("cost_factor"));
    if (map) {
      session_.set_map(*std::move(map), costmap_->getGlobalFrameID());
    } else {
      session_.clear_map(map.error().message);
    }
  }

  costmap_2d::Costmap2DROS* costmap_ = nullptr;  // move_base's
  Parameters parameters_;
  wend::Session session_{session_options()};
};

}  // namespace wend_ros

PLUGINLIB_EXPORT_CLASS(wend_ros::NavCorePlanner, nav_core::BaseGlobalPlanner)
