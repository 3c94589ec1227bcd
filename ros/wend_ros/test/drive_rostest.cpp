// drive.launch: map, planner, follower and simulated robot together, from a click to the goal.

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <signal.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <string>

#include "next_message.hpp"
#include "process_of_node.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_ros/pose_message.hpp"

namespace wend_ros {
namespace {

class Driving : public testing::Test {
 protected:
  void SetUp() override {
    goals_ = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
    starts_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
    states_ = node_.subscribe<std_msgs::String>("follower/state", 10,
                                                [this](const std_msgs::StringConstPtr& state) {
                                                  const std::lock_guard lock(mutex_);
                                                  state_ = state->data;
                                                });
    odometry_ = node_.subscribe<nav_msgs::Odometry>(
        "odom", 10, [this](const nav_msgs::OdometryConstPtr& odometry) {
          const std::lock_guard lock(mutex_);
          robot_ = *odometry;
        });
    plans_ = node_.subscribe<nav_msgs::Path>(
        "plan", 10, [this](const nav_msgs::PathConstPtr&) { ++plans_seen_; });
    ASSERT_TRUE(next<nav_msgs::Odometry>("odom"));
    ASSERT_TRUE(wait_until([this] { return goals_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(wait_until([this] { return starts_.getNumSubscribers() > 1; }));
  }

  void click(double x, double y, double heading = 0) const {
    geometry_msgs::PoseStamped goal;
    goal.header.frame_id = "map";
    goal.pose = to_message(wend::MapPose{x, y, heading});
    goals_.publish(goal);
  }

  void place(double x, double y) const {
    geometry_msgs::PoseWithCovarianceStamped start;
    start.header.frame_id = "map";
    start.pose.pose.position.x = x;
    start.pose.pose.position.y = y;
    start.pose.pose.orientation.w = 1;
    starts_.publish(start);
  }

  double distance_to(double x, double y) {
    const std::lock_guard lock(mutex_);
    return std::hypot(robot_.pose.pose.position.x - x, robot_.pose.pose.position.y - y);
  }

  double speed() {
    const std::lock_guard lock(mutex_);
    return std::abs(robot_.twist.twist.linear.x);
  }

  double heading() {
    const std::lock_guard lock(mutex_);
    return pose_from(robot_.pose.pose)->heading;
  }

  std::string state() {
    const std::lock_guard lock(mutex_);
    return state_;
  }

  ros::NodeHandle node_;
  ros::Publisher goals_;
  ros::Publisher starts_;
  ros::Subscriber states_;
  ros::Subscriber odometry_;
  ros::Subscriber plans_;
  std::mutex mutex_;
  std::string state_;
  nav_msgs::Odometry robot_;
  std::atomic<int> plans_seen_{0};
};

TEST_F(Driving, ReachesAGoalBehindAWallAndPlansAnewOnTheWay) {
  place(16.5, 28.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(16.5, 28.5) < 0.1; }));
  click(24.5, 28.5);
  ASSERT_TRUE(wait_until([this] { return state() == "driving"; }));
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
  EXPECT_LT(distance_to(24.5, 28.5), 0.5);
  EXPECT_GE(plans_seen_, 3);
}

TEST_F(Driving, TurnsToTheHeadingOfTheGoal) {
  constexpr double kHeading = 2.2;
  place(1.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(1.5, 1.5) < 0.1; }));
  click(5.5, 1.5, kHeading);
  ASSERT_TRUE(wait_until([&] {
    return state() == "reached" && std::abs(wend::normalized_angle(heading() - kHeading)) < 0.15;
  })) << state()
      << ' ' << heading();
  EXPECT_LT(distance_to(5.5, 1.5), 0.5);
}

TEST_F(Driving, TurnsToANewGoalWhileItDrives) {
  place(1.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(1.5, 1.5) < 0.1; }));
  click(15.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return speed() > 1; }));
  click(1.5, 8.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(1.5, 8.5) < 0.5; })) << state();
}

TEST_F(Driving, StopsWhereItIsToldTo) {
  place(1.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(1.5, 1.5) < 0.1; }));
  click(15.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return speed() > 1; }));
  auto cancels = node_.advertise<std_msgs::Empty>("cancel", 1);
  ASSERT_TRUE(wait_until([&] { return cancels.getNumSubscribers() == 2; }));
  cancels.publish(std_msgs::Empty());
  ASSERT_TRUE(wait_until([this] { return state() == "idle"; }));
  ASSERT_TRUE(wait_until([this] { return speed() == 0; }));
  EXPECT_TRUE(next<nav_msgs::Path>("plan")->poses.empty()) << "the plan is taken away";
  EXPECT_EQ(state(), "idle");
}

TEST_F(Driving, DoesNotDriveAStalePath) {
  auto paths = node_.advertise<nav_msgs::Path>("plan_smoothed", 1);
  ASSERT_TRUE(wait_until([&] { return paths.getNumSubscribers() > 0; }));
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.poses.resize(2);
  for (auto& stamped : path.poses) stamped.pose.orientation.w = 1;
  path.poses[0].pose.position.x = path.poses[1].pose.position.x = 1.5;
  path.poses[1].pose.position.y = 8.5;
  place(1.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(1.5, 1.5) < 0.1; }));
  path.header.stamp = ros::Time::now();
  paths.publish(path);
  ASSERT_TRUE(wait_until([this] { return state() == "driving"; })) << "a fresh one it drives";
  path.header.stamp = ros::Time::now() - ros::Duration(3600);
  paths.publish(path);
  ASSERT_TRUE(wait_until([this] { return state() == "idle"; })) << state();
  ASSERT_TRUE(wait_until([this] { return speed() == 0; }));
}

TEST_F(Driving, StopsWhereItsPoseIsLost) {
  place(1.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return distance_to(1.5, 1.5) < 0.1; }));
  click(15.5, 1.5);
  ASSERT_TRUE(wait_until([this] { return speed() > 1; }));
  const int pid = pid_of("/robot_sim");
  ASSERT_GT(pid, 0);
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  ASSERT_TRUE(wait_until([this] { return state() == "no_pose"; })) << state();
  // The launch file starts the robot anew, where it stood at first.
  EXPECT_TRUE(wait_until([this] { return state() != "no_pose"; })) << state();
}

TEST_F(Driving, EveryKilledNodeComesBackAndTheNextClickIsDriven) {
  for (const char* name : {"/map_server", "/planner_server", "/follower"}) {
    SCOPED_TRACE(name);
    const int pid = pid_of(name);
    ASSERT_GT(pid, 0);
    ASSERT_EQ(kill(pid, SIGKILL), 0);
    ASSERT_TRUE(wait_until([&] {
      const int now = pid_of(name);
      return now > 0 && now != pid;
    }));
  }
  place(1.5, 1.5);
  // A new process connects in its own time: people click again, too.
  EXPECT_TRUE(wait_until([this] {
    if (state() != "driving" && state() != "reached") click(1.5, 6.5);
    return distance_to(1.5, 6.5) < 0.5;
  })) << state();
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "drive_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
