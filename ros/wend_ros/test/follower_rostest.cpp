// What stands between planner and wheels: questions move nothing, a path that cannot be reached is refused, and the
// robot brakes while the path is blocked or somebody is silent. The robot drives at 0.5 m/s and brakes within 0.125 m.

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <signal.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <wend_ros/PlanPath.h>
#include <wend_ros/PlanPathAction.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "next_message.hpp"
#include "planner_client.hpp"
#include "process_of_node.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 80;
constexpr double kResolution = 0.125;  // m: the map has 20 x 10 m

/// The map of free cells, and updates of it; an empty update twenty times a second, by which it is not silent.
class Map {
 public:
  Map()
      : maps_(node_.advertise<nav_msgs::OccupancyGrid>("map", 1, true)),
        updates_(node_.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 100)) {
    nav_msgs::OccupancyGrid grid;
    grid.header.frame_id = "map";
    grid.header.stamp = ros::Time::now();
    grid.info.width = kWidth;
    grid.info.height = kHeight;
    grid.info.resolution = kResolution;
    grid.info.origin.orientation.w = 1;
    grid.data.assign(std::size_t{kWidth} * kHeight, 0);
    maps_.publish(grid);
    speak();
  }

  void speak() {
    timer_ = node_.createTimer(ros::Duration(0.05), [this](const ros::TimerEvent&) { put({}); });
  }
  void fall_silent() { timer_.stop(); }

  /// Gives all cells of a box (m) a value.
  void put(double x, double y, double width, double height, std::int8_t value) {
    map_msgs::OccupancyGridUpdate update;
    update.x = static_cast<std::int32_t>(x / kResolution);
    update.y = static_cast<std::int32_t>(y / kResolution);
    update.width = static_cast<std::uint32_t>(width / kResolution);
    update.height = static_cast<std::uint32_t>(height / kResolution);
    update.data.assign(std::size_t{update.width} * update.height, value);
    put(update);
  }

  void clear() { put(0, 0, kWidth * kResolution, kHeight * kResolution, 0); }

  std::uint32_t listeners() const {
    return std::min(maps_.getNumSubscribers(), updates_.getNumSubscribers());
  }

 private:
  void put(map_msgs::OccupancyGridUpdate update) {
    update.header.frame_id = "map";
    update.header.stamp = ros::Time::now();
    updates_.publish(update);
  }

  ros::NodeHandle node_;
  ros::Publisher maps_;
  ros::Publisher updates_;
  ros::Timer timer_;
};

class Guarded : public testing::Test {
 protected:
  static void SetUpTestSuite() { map_ = new Map; }
  static void TearDownTestSuite() { delete map_; }

  void SetUp() override {
    goals_ = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
    starts_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
    cancels_ = node_.advertise<std_msgs::Empty>("cancel", 1);
    paths_ = node_.advertise<nav_msgs::Path>("plan_smoothed", 1);
    client_ = node_.serviceClient<PlanPath>("plan_path");
    listen<std_msgs::String>("follower/state", [this](const auto& state) {
      state_ = state.data;
      states_.push_back(state.data);
    });
    listen<nav_msgs::Odometry>("odom", [this](const auto& odometry) {
      robot_ = *pose_from(odometry.pose.pose);
      const auto& twist = odometry.twist.twist;
      speed_ = std::abs(twist.linear.x) + std::abs(twist.angular.z);
    });
    listen<geometry_msgs::Twist>("cmd_vel", [this](const auto& twist) {
      if (twist.linear.x != 0 || twist.angular.z != 0) ++moving_commands_;
    });
    for (const char* topic : {"plan", "plan_smoothed", "trajectory"}) {
      listen<nav_msgs::Path>(topic, [this](const auto& path) {
        if (!path.poses.empty()) ++driven_paths_;
      });
    }
    ASSERT_TRUE(client_.waitForExistence(kPatience));
    ASSERT_TRUE(wait_until([this] {
      return goals_.getNumSubscribers() > 0 && starts_.getNumSubscribers() > 1 &&
             cancels_.getNumSubscribers() > 1 && paths_.getNumSubscribers() > 1 &&
             map_->listeners() > 1 && map_is_known();
    }));
    map_->clear();
    stand_at({1.5, 1.5, 0});
  }

  template <class Message, class Take>
  void listen(const std::string& topic, Take take) {
    subscribers_.push_back(node_.subscribe<Message>(
        topic, 100, [this, take](const boost::shared_ptr<const Message>& message) {
          const std::lock_guard lock(mutex_);
          take(*message);
        }));
  }

  bool map_is_known() { return ask(request(3, 3)).status != 250; }

  PlanResult ask(const PlanRequest& request) {
    PlanPath call;
    call.request.request = request;
    return client_.call(call) ? call.response.result : PlanResult();
  }

  /// Without a goal, at rest, at that pose.
  void stand_at(const wend::MapPose& at) {
    ASSERT_TRUE(wait_until([this] {
      cancels_.publish(std_msgs::Empty());
      return state() == "idle" && speed() == 0;
    }));
    geometry_msgs::PoseWithCovarianceStamped start;
    start.header.frame_id = "map";
    start.pose.pose = to_message(at);
    starts_.publish(start);
    ASSERT_TRUE(wait_until([&] { return distance_to(at) < 0.01; }));
    const std::lock_guard lock(mutex_);
    states_.clear();
    moving_commands_ = driven_paths_ = clicks_ = 0;
    clicked_ = {};
  }

  void click(const wend::MapPose& at) {
    geometry_msgs::PoseStamped goal = pose(at.x, at.y);
    goal.pose = to_message(at);
    goals_.publish(goal);
  }

  /// Clicks once a second while the robot is idle: a cancel from before may come after a click.
  void click_while_idle(const wend::MapPose& at) {
    const ros::WallTime now = ros::WallTime::now();
    if (state() != "idle" || (now - clicked_).toSec() < 1) return;
    clicked_ = now;
    ++clicks_;
    click(at);
  }

  void drive_to(const wend::MapPose& at) {
    ASSERT_TRUE(wait_until([&] {
      click_while_idle(at);
      return speed() > 0.4;
    })) << state();
  }

  template <class Value>
  Value locked(const Value& value) {
    const std::lock_guard lock(mutex_);
    return value;
  }
  std::string state() { return locked(state_); }
  double speed() { return locked(speed_); }
  wend::MapPose robot() { return locked(robot_); }
  double distance_to(const wend::MapPose& at) { return distance(robot().point(), at.point()); }
  bool was(const std::string& state) {
    const auto states = locked(states_);
    return std::find(states.begin(), states.end(), state) != states.end();
  }

  /// Waits until it stands in that state, and until more commands have come by which it would move.
  void expect_stands(const std::string& state_name) {
    ASSERT_TRUE(wait_until([&] { return state() == state_name; })) << state();
    ASSERT_TRUE(wait_until([this] { return speed() == 0; })) << speed();
    const wend::MapPose there = robot();
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(next<nav_msgs::Odometry>("odom"));
    EXPECT_LT(distance_to(there), 1e-6);
  }

  static Map* map_;
  ros::NodeHandle node_;
  ros::Publisher goals_;
  ros::Publisher starts_;
  ros::Publisher cancels_;
  ros::Publisher paths_;
  ros::ServiceClient client_;
  std::mutex mutex_;
  std::string state_;
  std::vector<std::string> states_;
  wend::MapPose robot_;
  double speed_ = 0;  // and the turn rate
  ros::WallTime clicked_;
  int clicks_ = 0;
  int moving_commands_ = 0;
  int driven_paths_ = 0;
  std::vector<ros::Subscriber> subscribers_;
};

Map* Guarded::map_ = nullptr;

TEST_F(Guarded, QuestionsMoveNothing) {
  nav_msgs::GetPlan call;
  call.request.start = pose(1.5, 1.5);
  call.request.goal = pose(15, 9);
  ASSERT_TRUE(ros::service::call("make_plan", call));
  EXPECT_FALSE(call.response.plan.poses.empty());
  ASSERT_TRUE(wait_until([] {
    const auto shown = next<nav_msgs::Path>("planner_server/queried_plan");
    return shown && !shown->poses.empty() &&
           std::abs(shown->poses.back().pose.position.x - 15) < 0.1;
  })) << "it is shown";
  for (int i = 0; i < 20; ++i) EXPECT_EQ(ask(request(15, 2 + 0.2 * i)).status, 0);
  actionlib::SimpleActionClient<PlanPathAction> action("plan_path_action", true);
  ASSERT_TRUE(action.waitForServer(kPatience));
  PlanPathGoal goal;
  goal.request = request(15, 9);
  EXPECT_EQ(action.sendGoalAndWait(goal, kPatience), actionlib::SimpleClientGoalState::SUCCEEDED);
  // What comes after the questions by the same connections would come after their paths.
  ASSERT_TRUE(wait_until([this] {
    click_while_idle({1.5, 1.5, 0});
    return was("reached");
  })) << state();
  EXPECT_LE(locked(driven_paths_), 3 * clicks_) << "plans to the goal, by their three topics";
  EXPECT_EQ(locked(moving_commands_), 0);
}

TEST_F(Guarded, QuestionsDoNotStopARobotOnItsWay) {
  drive_to({6, 1.5, 0});
  ASSERT_TRUE(wait_until([&] {
    EXPECT_EQ(ask(request(15, 9)).status, 0);
    return robot().x >= 5;
  })) << state();
  EXPECT_FALSE(was("off_path"));
  EXPECT_FALSE(was("refused"));
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
}

TEST_F(Guarded, TurnsToTheHeadingOfTheGoal) {
  for (const wend::MapPose goal : {wend::MapPose{3, 1.5, 2}, wend::MapPose{3, 1.5, -1}}) {
    stand_at({1.5, 1.5, 0});
    ASSERT_TRUE(wait_until([&] {
      click_while_idle(goal);
      return state() == "reached" && distance_to(goal) < 0.2 &&
             std::abs(wend::normalized_angle(robot().heading - goal.heading)) < 0.15;
    })) << state()
        << robot().heading;
  }
}

/// From `x` on along the row of the robot.
nav_msgs::Path straight_from(double x) {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.header.stamp = ros::Time::now();
  for (int i = 0; i < 30; ++i) path.poses.push_back(pose(x + 0.1 * i, 1.5));
  return path;
}

TEST_F(Guarded, RefusesAPathThatBeginsBehindAWall) {
  map_->put(1.875, 0, 0.25, 10, 100);
  ASSERT_TRUE(wait_until([&] { return ask(request(9, 1.5)).status == 208; }));
  paths_.publish(straight_from(2.4));
  expect_stands("refused");
  EXPECT_LT(distance_to({1.5, 1.5}), 1e-6);
  map_->clear();
  ASSERT_TRUE(wait_until([&] { return ask(request(9, 1.5)).status == 0; }));
  ASSERT_TRUE(wait_until([&] {
    if (state() == "refused") paths_.publish(straight_from(2.4));
    return state() == "driving";
  })) << "once the wall is gone it is driven";
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
}

TEST_F(Guarded, RefusesPathsWithPosesThatAreNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const int kind : {0, 1, 2, 3, 4}) {
    SCOPED_TRACE(kind);
    drive_to({12, 1.5, 0});
    nav_msgs::Path wrong = straight_from(robot().x);
    auto& changed = wrong.poses[7].pose;
    if (kind == 0) changed.position.x = none;
    if (kind == 1) changed.position.y = 1e300;
    if (kind == 2) changed.orientation.w = 0;
    if (kind == 3) changed.orientation.x = 1;
    if (kind == 4) changed.orientation.z = std::numeric_limits<double>::infinity();
    paths_.publish(wrong);
    expect_stands("idle");
    stand_at({1.5, 1.5, 0});
  }
}

TEST_F(Guarded, BrakesForAnObstacleOnThePathAndDrivesOnWhenItIsGone) {
  drive_to({12, 1.5, 0});
  const double wall = robot().x + 2.5;
  map_->put(wall, 0, 0.25, 5, 100);
  expect_stands("blocked");
  EXPECT_LT(robot().x, wall - 0.3) << "it does not touch";
  map_->clear();
  ASSERT_TRUE(wait_until([this] { return state() == "driving"; })) << state();
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
  EXPECT_LT(distance_to({12, 1.5}), 0.2);
}

TEST_F(Guarded, StandsSoonAfterThePlannerIsKilledAndForgetsItsPath) {
  drive_to({18, 1.5, 0});
  const int pid = pid_of("/planner_server");
  ASSERT_GT(pid, 0);
  const wend::MapPose there = robot();
  const ros::WallTime killed = ros::WallTime::now();
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  ASSERT_TRUE(wait_until([this] { return speed() == 0; }));
  std::cout << "it stood " << (ros::WallTime::now() - killed).toSec() << " s later, after "
            << distance_to(there) << " m\n";
  EXPECT_TRUE(was("no_planner"));
  EXPECT_LT(distance_to(there), 2) << "far from the goal";
  ASSERT_TRUE(wait_until([&] {
    const int now = pid_of("/planner_server");
    return now > 0 && now != pid;
  }));
  expect_stands("idle");
  EXPECT_LT(distance_to(there), 2);
  ASSERT_TRUE(wait_until([this] { return map_is_known(); }));
  // A new process connects in its own time: people click again, too.
  EXPECT_TRUE(wait_until([this] {
    click_while_idle({5, 1.5, 0});
    return state() == "reached";
  })) << state();
}

TEST_F(Guarded, DrivesOnWhenThePlannerWasOnlySilent) {
  drive_to({8, 1.5, 0});
  const int pid = pid_of("/planner_server");
  ASSERT_GT(pid, 0);
  ASSERT_EQ(kill(pid, SIGSTOP), 0);
  expect_stands("no_planner");
  ASSERT_EQ(kill(pid, SIGCONT), 0);
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
  EXPECT_LT(distance_to({8, 1.5}), 0.2);
}

TEST_F(Guarded, BrakesWhileTheMapIsSilent) {
  drive_to({12, 1.5, 0});
  map_->fall_silent();
  expect_stands("no_map");
  map_->speak();
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
}

TEST_F(Guarded, ARobotIsNotPlacedWhereNoneCanStand) {
  geometry_msgs::PoseWithCovarianceStamped start;
  start.header.frame_id = "map";
  start.pose.pose = to_message(wend::MapPose{1e300, 1.5, 0});
  starts_.publish(start);
  start.pose.pose.position.x = 9;
  start.pose.pose.orientation = {};
  starts_.publish(start);
  start.pose.pose.orientation.w = 1;
  start.pose.pose.position.x = 2;
  starts_.publish(start);
  ASSERT_TRUE(wait_until([this] { return distance_to({2, 1.5}) < 0.01; }));
  EXPECT_EQ(ask(request(5, 1.5)).status, 0);
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "follower_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
