#pragma once

// PlannerNode: the planners as services, an action and topics. Maps come in by /map; goals by rviz's
// tools, services and actions; every plan goes out by /plan and what shows it.
//
// Planning runs in threads of its own: one for goals that come by topics, one for the action's, and
// those of the services' spinner. A new goal by topic stops the search for the one before. With the
// parameter replan_rate (Hz) the plan to that goal is made anew until the robot is there, or /cancel
// says to leave it.

#include <actionlib/server/simple_action_server.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <wend_ros/PlanPath.h>
#include <wend_ros/PlanPathAction.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "wend_ros/map_message.hpp"
#include "wend_ros/planning.hpp"
#include "wend_ros/reconfigure.hpp"
#include "wend_ros/robot_pose.hpp"
#include "wend_ros/search_watch.hpp"

namespace wend_ros {

class PlannerNode {
 public:
  /// Services are called from the queue of `services`. With the parameter ~map, a file, the map is
  /// that one until another comes by /map.
  PlannerNode(ros::NodeHandle& node, ros::NodeHandle& own, ros::NodeHandle& services);
  ~PlannerNode();
  PlannerNode(const PlannerNode&) = delete;
  PlannerNode& operator=(const PlannerNode&) = delete;

 private:
  using ActionServer = actionlib::SimpleActionServer<PlanPathAction>;

  void load_map_parameter(ros::NodeHandle& own);
  void take_map(const nav_msgs::OccupancyGrid& message);
  void take_goal_parameter(ros::NodeHandle& own);
  void take_goal(const geometry_msgs::PoseStamped& goal);
  void cancel(const std_msgs::Empty& message);
  void take_start(const geometry_msgs::PoseWithCovarianceStamped& start);
  bool make_plan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  bool plan_path(PlanPath::Request& request, PlanPath::Response& response);
  void execute(const PlanPathGoalConstPtr& goal);

  /// Plans, publishes and tells the log.
  Answer answer(const PlanRequest& request, const std::atomic<bool>* cancel, SearchWatch* watch);
  /// The request in the map's frame, or why it cannot be.
  wend::Expected<Ask, PlanResult> ask_of(const PlanRequest& request,
                                         const wend::Session::View& map) const;
  void publish(const Answer& answer, const wend::Session::View& map, const SearchWatch* watch);

  void plan_for_topics();
  bool wait_for_topics();
  void wake();

  wend::Session session_{session_options()};
  MapReading reading_;
  RobotPose robot_;
  std::unique_ptr<Reconfigure> reconfigure_;

  ros::Publisher plan_;
  ros::Publisher smoothed_;
  ros::Publisher trajectory_;
  ros::Publisher poses_;
  ros::Publisher expansion_;
  ros::Publisher markers_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> servers_;

  // What topics asked for last.
  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<geometry_msgs::PoseStamped> goal_;
  bool wanted_ = false;
  bool active_ = false;  // the robot is on its way to that goal
  bool stopping_ = false;
  double replan_period_ = 0;  // s; 0: only when something new comes
  std::atomic<bool> cancel_topics_{false};
  std::atomic<bool> cancel_action_{false};
  std::thread worker_;

  std::unique_ptr<ActionServer> action_;
};

}  // namespace wend_ros
