// SPDX-License-Identifier: Apache-2.0
//
// The controller as the controller server uses it: loaded by pluginlib, on a Costmap2DROS.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include <tf2_ros/buffer.h>
#include <nav2_core/controller.hpp>
#include <nav2_core/controller_exceptions.hpp>
#include <pluginlib/class_loader.hpp>
#include <rclcpp/rclcpp.hpp>

#include "plugins_fixture.hpp"

#if !WEND_NAV2_VIAPOINTS
namespace wend_nav2 {
namespace {

/// Says that the goal is reached within 0.2 m, whatever the heading.
class AnyHeading final : public nav2_core::GoalChecker {
 public:
  void initialize(const Node::WeakPtr&, const std::string&,
                  std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) override {}
  void reset() override {}
  bool isGoalReached(const geometry_msgs::msg::Pose&, const geometry_msgs::msg::Pose&,
                     const geometry_msgs::msg::Twist&) override {
    return false;
  }
  bool getTolerances(geometry_msgs::msg::Pose& pose, geometry_msgs::msg::Twist&) override {
    pose.position.x = pose.position.y = 0.2;
    pose.orientation.w = -1;  // two half turns
    return true;
  }
};

class ControllerPlugin : public Plugins {
 protected:
  std::shared_ptr<nav2_core::Controller> controller() {
    node_->declare_parameter("controller_frequency", 10.0);
    std::shared_ptr<nav2_core::Controller> made =
        controllers_.createSharedInstance("wend_nav2::Controller");
    made->configure(node_, "wend", std::make_shared<tf2_ros::Buffer>(node_->get_clock()), costmap_);
    made->activate();
    return made;
  }

  static nav_msgs::msg::Path line(double from, double to, double y) {
    nav_msgs::msg::Path path;
    path.header.frame_id = "map";
    for (double x = from; x < to; x += 0.05) path.poses.push_back(pose(x, y));
    return path;
  }

  double speed(nav2_core::Controller& made, double x, double y) {
    return made.computeVelocityCommands(pose(x, y), geometry_msgs::msg::Twist(), &any_heading_)
        .twist.linear.x;
  }

  AnyHeading any_heading_;
  pluginlib::ClassLoader<nav2_core::Controller> controllers_{"nav2_core", "nav2_core::Controller"};
};

TEST_F(ControllerPlugin, IsLoadedAndFollowsAPath) {
  const auto made = controller();
  made->setPlan(line(0.5, 4.5, 2));
  double x = 0.5;
  double fastest = 0;
  for (int i = 0; i < 150; ++i) {
    const double now = speed(*made, x, 2);
    fastest = std::max(fastest, now);
    x += now * 0.1;
  }
  EXPECT_NEAR(fastest, 0.5, 1e-6);
  EXPECT_NEAR(x, 4.45, 0.2);
  EXPECT_EQ(speed(*made, x, 2), 0);
}

TEST_F(ControllerPlugin, KeepsSpeedLimitsAndBrakesWhenCancelled) {
  const auto made = controller();
  made->setPlan(line(0.5, 4.5, 2));
  double x = 0.5;
  const auto drive = [&] {
    const double now = speed(*made, x, 2);
    x += now * 0.1;
    return now;
  };
  for (int i = 0; i < 10; ++i) drive();
  made->setSpeedLimit(40, true);
  for (int i = 0; i < 10; ++i) drive();
  EXPECT_NEAR(drive(), 0.2, 1e-6);
  made->setSpeedLimit(0.3, false);
  for (int i = 0; i < 10; ++i) drive();
  EXPECT_NEAR(drive(), 0.3, 1e-6);
  made->setSpeedLimit(0, false);
  for (int i = 0; i < 10; ++i) drive();
  EXPECT_NEAR(drive(), 0.5, 1e-6);
  EXPECT_FALSE(made->cancel());
  for (int i = 0; i < 10 && !made->cancel(); ++i) drive();
  EXPECT_TRUE(made->cancel());
  EXPECT_EQ(drive(), 0);
}

TEST_F(ControllerPlugin, FailuresAreNav2sExceptions) {
  const auto made = controller();
  EXPECT_THROW(speed(*made, 1, 1), nav2_core::InvalidPath);
  made->setPlan(nav_msgs::msg::Path());
  EXPECT_THROW(speed(*made, 1, 1), nav2_core::InvalidPath);
  made->setPlan(line(0.5, 4.5, 2));
  EXPECT_THROW(speed(*made, 1, 0.2), nav2_core::InvalidPath);
  build_wall(0);
  made->setPlan(line(2.3, 4.5, 2));
  EXPECT_THROW(speed(*made, 2.4, 2), nav2_core::NoValidControl);
  auto elsewhere = line(0.5, 4.5, 2);
  elsewhere.header.frame_id = "nowhere";
  made->setPlan(elsewhere);
  EXPECT_THROW(speed(*made, 0.5, 2), nav2_core::ControllerTFError);
}

TEST_F(ControllerPlugin, RefusesOrientationsThatAreNone) {
  const auto made = controller();
  auto path = line(0.5, 4.5, 2);
  path.poses[20].pose.orientation = geometry_msgs::msg::Quaternion();
  path.poses[20].pose.orientation.w = 0;
  made->setPlan(path);
  EXPECT_THROW(speed(*made, 0.5, 2), nav2_core::InvalidPath);
  EXPECT_THROW(speed(*made, 0.5, 2), nav2_core::InvalidPath) << "there is none then";
  made->setPlan(line(0.5, 4.5, 2));
  EXPECT_GT(speed(*made, 0.5, 2), 0);
}

TEST_F(ControllerPlugin, AnOldPoseIsNoPose) {
  const auto made = controller();
  made->setPlan(line(0.5, 4.5, 2));
  const auto speed_at_age = [&](double age) {
    auto robot = pose(0.5, 2);
    robot.header.stamp = node_->now() - rclcpp::Duration::from_seconds(age);
    return made->computeVelocityCommands(robot, geometry_msgs::msg::Twist(), &any_heading_)
        .twist.linear.x;
  };
  EXPECT_GT(speed_at_age(0), 0);
  EXPECT_THROW(speed_at_age(30), nav2_core::ControllerTFError);
  EXPECT_TRUE(node_->set_parameter({"wend.pose_timeout", 0.0}).successful);
  EXPECT_GT(speed_at_age(30), 0);
}

TEST_F(ControllerPlugin, RefusesParametersThatDoNotFit) {
  const auto made = controller();
  EXPECT_FALSE(node_->set_parameter({"wend.speed", -1.0}).successful);
  EXPECT_TRUE(node_->set_parameter({"wend.speed", 0.25}).successful);
  made->setPlan(line(0.5, 4.5, 2));
  double x = 0.5;
  for (int i = 0; i < 10; ++i) x += speed(*made, x, 2) * 0.1;
  EXPECT_NEAR(speed(*made, x, 2), 0.25, 1e-6);
}

}  // namespace
}  // namespace wend_nav2
#endif
