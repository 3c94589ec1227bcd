#include "wend_ros/plan_publisher.hpp"

#include <geometry_msgs/PoseArray.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>

#include "wend_ros/markers.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {

PlanPublisher::PlanPublisher(ros::NodeHandle& node, ros::NodeHandle& own)
    : plan_(node.advertise<nav_msgs::Path>("plan", 1, true)),
      smoothed_(node.advertise<nav_msgs::Path>("plan_smoothed", 1, true)),
      trajectory_(node.advertise<nav_msgs::Path>("trajectory", 1, true)),
      poses_(node.advertise<geometry_msgs::PoseArray>("plan_poses", 1, true)),
      expansion_(node.advertise<nav_msgs::OccupancyGrid>("expansion", 1, true)),
      markers_(node.advertise<visualization_msgs::MarkerArray>("markers", 8, true)),
      results_(node.advertise<PlanResult>("plan_result", 1, true)),
      queried_plan_(own.advertise<nav_msgs::Path>("queried_plan", 1, true)),
      queried_markers_(own.advertise<visualization_msgs::MarkerArray>("queried_markers", 1, true)),
      alive_(node.advertise<PlannerAlive>("planner_alive", 1)) {
  sign_.began = ros::Time::now();
}

void PlanPublisher::tell_alive() const { alive_.publish(sign_); }

void PlanPublisher::show_map(const wend::GridMap& map, const std::string& frame_id) const {
  // rviz draws a box for each; of large maps /map itself has to do.
  constexpr std::size_t kMostBoxes = 250'000;
  if (map.size() <= kMostBoxes) markers_.publish(yard_markers(map, frame_id));
}

void PlanPublisher::show(const Answer& answer, const wend::Session::View& map,
                         const SearchWatch* watch) const {
  const PlanResult& result = answer.result;
  const ros::Time now = ros::Time::now();
  nav_msgs::Path path = answer.way;
  path.header.frame_id = map.frame_id;
  path.header.stamp = now;
  plan_.publish(path);
  geometry_msgs::PoseArray poses = poses_of(result.path);
  poses.header = path.header;
  poses_.publish(poses);
  nav_msgs::Path smoothed = result.smoothed.poses.empty() ? path : result.smoothed;
  smoothed.header = path.header;
  smoothed_.publish(smoothed);
  nav_msgs::Path trajectory = starting_at(now, result.trajectory);
  trajectory.header.frame_id = map.frame_id;
  trajectory_.publish(trajectory);
  markers_.publish(
      path_markers({answer.path, map.space.map().frame(), map.frame_id}, map.space.footprint()));
  if (watch != nullptr && !watch->order().empty()) {
    expansion_.publish(heatmap_of(watch->order(), map.space.map(), map.frame_id));
  }
}

void PlanPublisher::show_queried(const Answer& answer, const wend::Session::View& map) const {
  nav_msgs::Path path = answer.way;
  path.header.frame_id = map.frame_id;
  path.header.stamp = ros::Time::now();
  queried_plan_.publish(path);
  queried_markers_.publish(
      path_markers({answer.path, map.space.map().frame(), map.frame_id}, map.space.footprint()));
}

}  // namespace wend_ros
