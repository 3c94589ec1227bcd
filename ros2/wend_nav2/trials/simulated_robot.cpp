// SPDX-License-Identifier: Apache-2.0
//
// simulated_robot: drives as /cmd_vel says, tells /odom and tf where it is, and counts where its disc meets an obstacle
// of /map. It drives through obstacles.
//
//   simulated_robot --ros-args -p x:=1.0 -p y:=1.0 -p heading:=0.0 -p radius:=0.2
//
// The frame `odom` lies at (odom_x, odom_y), turned by odom_heading, in the frame `map`. Prints its pose, the distance
// that it drove, the fastest and the slowest speed, and collisions each time it has stopped.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <rclcpp/rclcpp.hpp>

#include "../src/pose_messages.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/geometry/frame.hpp"

namespace {

constexpr double kPeriod = 0.02;         // s
constexpr double kCommandTimeout = 0.5;  // s: a robot without commands stops

geometry_msgs::msg::TransformStamped transform_of(const wend::MapPose& pose,
                                                  const std::string& from, const std::string& to,
                                                  const rclcpp::Time& stamp) {
  const geometry_msgs::msg::Pose message = wend_nav2::to_message(pose);
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = from;
  transform.child_frame_id = to;
  transform.transform.translation.x = message.position.x;
  transform.transform.translation.y = message.position.y;
  transform.transform.rotation = message.orientation;
  return transform;
}

/// Does a disc come closer than its radius to an occupied cell of a map without a rotation?
bool meets(const nav_msgs::msg::OccupancyGrid& map, const wend::MapPose& pose, double radius) {
  const double size = map.info.resolution;
  const double x = pose.x - map.info.origin.position.x;
  const double y = pose.y - map.info.origin.position.y;
  const int width = static_cast<int>(map.info.width);
  const int height = static_cast<int>(map.info.height);
  const auto first = [&](double middle) {
    return std::max(0, static_cast<int>((middle - radius) / size));
  };
  const auto last = [&](double middle, int count) {
    return std::min(count - 1, static_cast<int>((middle + radius) / size));
  };
  for (int row = first(y); row <= last(y, height); ++row) {
    for (int column = first(x); column <= last(x, width); ++column) {
      if (map.data[static_cast<std::size_t>(row) * map.info.width +
                   static_cast<std::size_t>(column)] < 65)
        continue;
      const double dx = std::max({column * size - x, x - (column + 1) * size, 0.0});
      const double dy = std::max({row * size - y, y - (row + 1) * size, 0.0});
      if (std::hypot(dx, dy) < radius) return true;
    }
  }
  return false;
}

class SimulatedRobot : public rclcpp::Node {
 public:
  SimulatedRobot() : Node("simulated_robot"), moves_(*this), stays_(*this) {
    odom_ = {declare_parameter("odom_x", 0.0), declare_parameter("odom_y", 0.0),
             declare_parameter("odom_heading", 0.0)};
    radius_ = declare_parameter("radius", 0.2);
    const wend::MapPose start{declare_parameter("x", 0.0), declare_parameter("y", 0.0),
                              declare_parameter("heading", 0.0)};
    const wend::Pose in_odom = odom_frame().to_grid(start);
    pose_ = {in_odom.x, in_odom.y, in_odom.heading};
    odometry_ = create_publisher<nav_msgs::msg::Odometry>("odom", 10);
    commands_ = create_subscription<geometry_msgs::msg::Twist>(
        "cmd_vel", 1, [this](const geometry_msgs::msg::Twist& command) {
          command_ = {command.linear.x, command.angular.z};
          commanded_ = now();
        });
    maps_ = create_subscription<nav_msgs::msg::OccupancyGrid>(
        "map", rclcpp::QoS(1).transient_local().reliable(),
        [this](const nav_msgs::msg::OccupancyGrid& map) { map_ = map; });
    stays_.sendTransform(transform_of(odom_, "map", "odom", now()));
    timer_ = create_wall_timer(std::chrono::duration<double>(kPeriod), [this] { step(); });
  }

 private:
  wend::Frame odom_frame() const { return {.resolution = 1, .origin = odom_}; }

  wend::MapPose in_map() const {
    return odom_frame().to_metres(wend::Pose{pose_.x, pose_.y, pose_.heading});
  }

  void step() {
    if ((now() - commanded_).seconds() > kCommandTimeout) command_ = {};
    pose_ = wend::hold(pose_, command_, kPeriod).to.pose;
    driven_ += std::abs(command_.linear) * kPeriod;
    fastest_ = std::max(fastest_, command_.linear);
    slowest_ = std::min(slowest_, command_.linear);
    const bool met = map_ && meets(*map_, in_map(), radius_);
    if (met && !met_) ++collisions_;
    met_ = met;
    publish();
    const bool stands = command_ == wend::Velocity{};
    if (stands && !stood_) report();
    stood_ = stands;
  }

  void publish() {
    const rclcpp::Time stamp = now();
    moves_.sendTransform(transform_of(pose_, "odom", "base_link", stamp));
    nav_msgs::msg::Odometry message;
    message.header.stamp = stamp;
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    message.pose.pose = wend_nav2::to_message(pose_);
    message.twist.twist.linear.x = command_.linear;
    message.twist.twist.angular.z = command_.angular;
    odometry_->publish(message);
  }

  void report() const {
    const wend::MapPose at = in_map();
    std::printf("robot at %.2f,%.2f,%.2f driven %.2f m speeds %.2f to %.2f m/s collisions %d\n",
                at.x, at.y, at.heading, driven_, slowest_, fastest_, collisions_);
    std::fflush(stdout);
  }

  tf2_ros::TransformBroadcaster moves_;
  tf2_ros::StaticTransformBroadcaster stays_;
  wend::MapPose odom_;  // of its frame, in the map
  wend::MapPose pose_;  // in the frame odom
  double radius_ = 0;
  wend::Velocity command_;
  rclcpp::Time commanded_{0, 0, RCL_ROS_TIME};
  std::optional<nav_msgs::msg::OccupancyGrid> map_;
  double driven_ = 0;
  double fastest_ = 0;
  double slowest_ = 0;
  int collisions_ = 0;
  bool met_ = false;
  bool stood_ = true;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<nav_msgs::msg::OccupancyGrid>::SharedPtr maps_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SimulatedRobot>());
  rclcpp::shutdown();
  return 0;
}
