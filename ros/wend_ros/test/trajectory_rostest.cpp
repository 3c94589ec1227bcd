// drive.launch with motion primitives of a file and the controller `trajectory`: from a click with a heading
// to a robot that stands there so, and what makes the follower stop.

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <wend_ros/PlanPath.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

#include "next_message.hpp"
#include "planner_client.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_ros/path_message.hpp"

namespace wend_ros {
namespace {

constexpr double kUp = wend::kPi / 2;

geometry_msgs::PoseStamped pose_of(const wend::MapPose& at) {
  geometry_msgs::PoseStamped stamped = pose(at.x, at.y);
  stamped.pose = to_message(at);
  return stamped;
}

/// At constant speed from (3.5,3.5) on, `metres` to +x, for a robot that starts now.
nav_msgs::Path straight(double metres, double speed = 1) {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.header.stamp = ros::Time::now();
  constexpr double kPeriod = 0.1;
  for (int i = 0; i * kPeriod * speed <= metres; ++i) {
    path.poses.push_back(pose_of({3.5 + i * kPeriod * speed, 3.5, 0}));
    path.poses.back().header.stamp = path.header.stamp + ros::Duration(i * kPeriod);
  }
  return path;
}

class Tracking : public testing::Test {
 protected:
  void SetUp() override {
    goals_ = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
    starts_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
    cancels_ = node_.advertise<std_msgs::Empty>("cancel", 1);
    trajectories_ = node_.advertise<nav_msgs::Path>("trajectory", 1);
    states_ = node_.subscribe<std_msgs::String>("follower/state", 10,
                                                [this](const std_msgs::StringConstPtr& state) {
                                                  const std::lock_guard lock(mutex_);
                                                  state_ = state->data;
                                                });
    odometry_ = node_.subscribe<nav_msgs::Odometry>(
        "odom", 10, [this](const nav_msgs::OdometryConstPtr& odometry) {
          const std::lock_guard lock(mutex_);
          robot_ = *pose_from(odometry->pose.pose);
          speed_ = odometry->twist.twist.linear.x;
          fastest_ = std::max(fastest_, speed_);
        });
    ASSERT_TRUE(next<nav_msgs::Odometry>("odom"));
    ASSERT_TRUE(next<nav_msgs::OccupancyGrid>("map"));
    ASSERT_TRUE(wait_until([this] {
      return goals_.getNumSubscribers() > 0 && starts_.getNumSubscribers() > 1 &&
             cancels_.getNumSubscribers() > 1 && trajectories_.getNumSubscribers() > 0;
    }));
    forget_goal();
  }

  /// The planner sends an empty trajectory, which must not come later.
  void forget_goal() {
    std::atomic<int> empty = 0;
    const auto watcher = node_.subscribe<nav_msgs::Path>(
        "plan", 10, [&](const nav_msgs::PathConstPtr& path) { empty += path->poses.empty(); });
    ASSERT_TRUE(wait_until([&] {
      cancels_.publish(std_msgs::Empty());
      return empty > 0 && state() == "idle";
    }));
    ASSERT_TRUE(wait_until([this] { return speed() == 0; }));
  }

  void place(const wend::MapPose& at) {
    geometry_msgs::PoseWithCovarianceStamped start;
    start.header.frame_id = "map";
    start.pose.pose = to_message(at);
    starts_.publish(start);
    ASSERT_TRUE(wait_until([&] { return is_at(at, 0.01); }));
    const std::lock_guard lock(mutex_);
    fastest_ = 0;
  }

  bool is_at(const wend::MapPose& at, double metres, double radians = 0.15) {
    const std::lock_guard lock(mutex_);
    return distance(robot_.point(), at.point()) < metres &&
           std::abs(wend::normalized_angle(robot_.heading - at.heading)) < radians;
  }

  wend::MapPose robot() {
    const std::lock_guard lock(mutex_);
    return robot_;
  }

  double speed() {
    const std::lock_guard lock(mutex_);
    return speed_;
  }

  std::string state() {
    const std::lock_guard lock(mutex_);
    return state_;
  }

  void drive_to(const wend::MapPose& goal) {
    goals_.publish(pose_of(goal));
    ASSERT_TRUE(wait_until([this] { return state() == "driving"; })) << state();
    ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
    EXPECT_TRUE(is_at(goal, 0.2)) << robot().x << " " << robot().y << " " << robot().heading;
  }

  /// Sends it while the robot tracks a straight line, and expects that the robot stops.
  void expect_stops(const nav_msgs::Path& trajectory, const std::string& why = "idle") {
    place({3.5, 3.5, 0});
    trajectories_.publish(straight(15));
    ASSERT_TRUE(wait_until([this] { return speed() > 0.5; })) << state();
    trajectories_.publish(trajectory);
    ASSERT_TRUE(wait_until([&] { return state() == why; })) << state();
    ASSERT_TRUE(wait_until([this] { return speed() == 0; }));
    EXPECT_LT(robot().x, 15) << "long before the end of the line";
    EXPECT_EQ(state(), why);
  }

  ros::NodeHandle node_;
  ros::Publisher goals_;
  ros::Publisher starts_;
  ros::Publisher cancels_;
  ros::Publisher trajectories_;
  ros::Subscriber states_;
  ros::Subscriber odometry_;
  std::mutex mutex_;
  std::string state_;
  wend::MapPose robot_;
  double speed_ = 0;
  double fastest_ = 0;  // since the last place()
};

TEST_F(Tracking, APlanByPrimitivesOfAFileHasTheHeadingsOfItsEnds) {
  PlanPath call;
  call.request.request.use_start = 1;
  call.request.request.start = pose_of({3.5, 3.5, kUp});
  call.request.request.goals = {pose_of({10.5, 6.5, wend::kPi})};
  ASSERT_TRUE(ros::service::call("plan_path", call));
  const PlanResult& result = call.response.result;
  ASSERT_EQ(result.status, 0) << result.reason;
  const auto& poses = result.path.poses;
  EXPECT_NEAR(pose_from(poses.front().pose)->heading, kUp, 1e-9);
  EXPECT_NEAR(std::abs(pose_from(poses.back().pose)->heading), wend::kPi, 1e-9);
  EXPECT_EQ(result.moves.size() + 1, poses.size());
  EXPECT_EQ(poses.back().pose.position.x, 10.5);
  const auto& timed = result.trajectory.poses;
  ASSERT_GT(timed.size(), poses.size());
  EXPECT_NEAR(std::abs(pose_from(timed.back().pose)->heading), wend::kPi, 1e-9);
}

TEST_F(Tracking, APlanForFollowersHasPosesOnTheArcs) {
  nav_msgs::GetPlan call;
  call.request.start = pose_of({3.5, 3.5, 0});
  call.request.goal = pose_of({10.5, 6.5, kUp});
  ASSERT_TRUE(ros::service::call("make_plan", call));
  const auto& poses = call.response.plan.poses;
  ASSERT_GT(poses.size(), 2U);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double turn = pose_from(poses[i].pose)->heading - pose_from(poses[i - 1].pose)->heading;
    EXPECT_LT(std::abs(turn), 0.3) << "a quarter circle has more than one pose";
  }
  EXPECT_EQ(next<nav_msgs::Path>("planner_server/queried_plan")->poses.size(), poses.size());
}

TEST_F(Tracking, DrivesPlansByPrimitivesToTheHeadingOfTheGoal) {
  place({3.5, 3.5, 0});
  drive_to({10.5, 6.5, kUp});
  drive_to({5.5, 12.5, 0});
}

TEST_F(Tracking, TurnsInPlaceToTheHeadingOfTheGoal) {
  place({5.5, 5.5, 0});
  drive_to({5.5, 5.5, wend::kPi});
  EXPECT_TRUE(is_at({5.5, 5.5, wend::kPi}, 0.1));
}

TEST_F(Tracking, KeepsToTheTimesOfATrajectory) {
  place({3.5, 3.5, 0});
  trajectories_.publish(straight(6, 0.5));
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
  EXPECT_TRUE(is_at({9.5, 3.5, 0}, 0.2));
  const std::lock_guard lock(mutex_);
  EXPECT_GT(fastest_, 0.4);
  EXPECT_LT(fastest_, 1) << "it catches up, but its limit is 2 m/s";
}

TEST_F(Tracking, TurnsFirstWhereItFacesAnotherWay) {
  place({3.5, 3.5, wend::kPi});
  trajectories_.publish(straight(6));
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
  EXPECT_TRUE(is_at({9.5, 3.5, 0}, 0.2)) << "and not in reverse";
}

TEST_F(Tracking, TakesANewTrajectoryInPlaceOfTheOldOne) {
  place({3.5, 3.5, 0});
  trajectories_.publish(straight(15));
  ASSERT_TRUE(wait_until([this] { return speed() > 0.5; })) << state();
  nav_msgs::Path other;
  other.header.frame_id = "map";
  other.header.stamp = ros::Time::now();
  const wend::MapPose from = robot();
  for (int i = 0; i <= 30; ++i) {  // a line to +y, from where it is
    other.poses.push_back(pose_of({from.x + 0.5, from.y + 0.1 * i, kUp}));
    other.poses.back().header.stamp = other.header.stamp + ros::Duration(0.1 * i);
  }
  trajectories_.publish(other);
  ASSERT_TRUE(wait_until([this] { return state() == "reached"; })) << state();
  EXPECT_TRUE(is_at({from.x + 0.5, from.y + 3, kUp}, 0.2));
}

TEST_F(Tracking, StopsForAnEmptyTrajectory) { expect_stops({}); }

TEST_F(Tracking, StopsForAStaleTrajectory) {
  nav_msgs::Path stale = straight(15);
  stale.header.stamp -= ros::Duration(3600);
  expect_stops(stale);
}

TEST_F(Tracking, StopsForATrajectoryThatContainsNaN) {
  nav_msgs::Path wrong = straight(15);
  wrong.poses[3].pose.position.x = std::numeric_limits<double>::quiet_NaN();
  expect_stops(wrong);
}

TEST_F(Tracking, StopsForATrajectoryWhoseStampsDoNotIncrease) {
  nav_msgs::Path wrong = straight(15);
  std::swap(wrong.poses[3].header.stamp, wrong.poses[4].header.stamp);
  expect_stops(wrong);
}

TEST_F(Tracking, StopsForATrajectoryThatIsFasterThanTheRobot) { expect_stops(straight(15, 3)); }

TEST_F(Tracking, StopsForATrajectoryInAnUnknownFrame) {
  nav_msgs::Path astray = straight(15);
  astray.header.frame_id = "moon";
  for (auto& stamped : astray.poses) stamped.header.frame_id = "moon";
  expect_stops(astray, "no_pose");
}

TEST_F(Tracking, StopsForATrajectoryThatBeginsElsewhere) {
  nav_msgs::Path far = straight(5);
  for (auto& stamped : far.poses) stamped.pose.position.y += 5;
  expect_stops(far, "off_path");
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "trajectory_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
