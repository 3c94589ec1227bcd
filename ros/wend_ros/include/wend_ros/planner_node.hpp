#pragma once

// PlannerNode: the planners as services, an action and topics. Maps come in by /map and /map_updates, goals by rviz's
// tools, questions by services and the action. A plan to a goal goes out by /plan and its like, which followers
// drive; the answer to a question moves nothing, and is shown by ~queried_plan.
//
// Planning runs in threads of its own: one for goals that come by topics, one for the action's, and
// those of the services' spinner. A new goal by topic stops the search for the one before. With the
// parameter replan_rate (Hz) the plan to that goal is made anew until the robot is there, or /cancel
// says to leave it. A change of the map is a reason to plan anew, too, but does not stop a search: it is compared
// with what the search finds.

#include <actionlib/server/simple_action_server.h>
#include <nav_msgs/GetPlan.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <wend_ros/PlanPath.h>
#include <wend_ros/PlanPathAction.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "wend_ros/map_feed.hpp"
#include "wend_ros/plan_publisher.hpp"
#include "wend_ros/planning.hpp"
#include "wend_ros/reconfigure.hpp"
#include "wend_ros/replanning.hpp"
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
  using Map = wend::Expected<MapFeed::Now, wend::Error>;

  /// Why topics have a plan made; the greater one counts.
  enum class Reason {
    none,
    change,  // of the map
    lost,    // the robot's pose was unknown
    time,    // ~replan_rate
    asked,   // a goal, a start, a parameter or another map
  };

  void take_parameters(const Parameters& parameters);
  void take_change(const MapFeed::Change& change);
  void show_edited_map(const ros::WallTimerEvent& event);
  void tell_alive(const ros::WallTimerEvent& event);
  void take_goal_parameter(ros::NodeHandle& own);
  void take_goal(const geometry_msgs::PoseStamped& goal);
  void cancel(const std_msgs::Empty& message);
  void take_start(const geometry_msgs::PoseWithCovarianceStamped& start);
  bool make_plan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  bool plan_path(PlanPath::Request& request, PlanPath::Response& response);
  void execute(const PlanPathGoalConstPtr& goal);

  /// How a plan is made.
  struct Manner {
    const std::atomic<bool>* cancel = nullptr;
    SearchWatch* watch = nullptr;
    bool explain = true;
    double keep = 0;  // as Ask::keep: for the robot's own path
  };

  Answer answer(const Map& map, const PlanRequest& request, const Manner& manner);
  /// Answers a question on the map of now, shows the answer, and tells the log.
  Answer answer(const PlanRequest& request, const std::atomic<bool>* cancel, SearchWatch* watch);
  /// The request in the map's frame, or why it cannot be.
  wend::Expected<Ask, PlanResult> ask_of(const PlanRequest& request,
                                         const wend::Session::View& map) const;

  void plan_for_topics();
  void plan_to(const geometry_msgs::PoseStamped& goal, Reason reason);
  Reason wait_for_topics();
  double period() const;
  bool knows_pose() const;
  void wake();

  wend::Session session_{session_options()};
  PlanPublisher publisher_;
  RobotPose robot_;
  std::unique_ptr<Reconfigure> reconfigure_;
  std::unique_ptr<MapFeed> feed_;
  std::atomic<bool> edited_{false};  // since the map was shown
  ros::WallTimer show_timer_;
  ros::WallTimer alive_timer_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> servers_;

  // What topics asked for last.
  std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<geometry_msgs::PoseStamped> goal_;
  Reason wanted_ = Reason::none;
  Replanning replanning_;
  bool active_ = false;   // the robot is on its way to that goal
  bool arrived_ = false;  // it was there at the last plan
  bool lost_ = false;     // its pose was unknown then
  bool stopping_ = false;
  double replan_period_ = 0;  // s; 0: only when something new comes
  std::atomic<bool> cancel_topics_{false};
  std::atomic<bool> cancel_action_{false};
  std::thread worker_;

  std::unique_ptr<ActionServer> action_;
};

}  // namespace wend_ros
