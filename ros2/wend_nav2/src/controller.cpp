// SPDX-License-Identifier: Apache-2.0
//
// wend_nav2/Controller: wend's controllers as a controller of Nav2.
//
//   controller_server:
//     ros__parameters:
//       controller_plugins: ["FollowPath"]
//       FollowPath:
//         plugin: "wend_nav2::Controller"
//         controller: "pure_pursuit"

#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tf2/exceptions.h>
#include <tf2_ros/buffer.h>
#include <nav2_core/controller.hpp>
#include <nav2_core/controller_exceptions.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "conversions.hpp"
#include "nav2_types.hpp"
#include "plugin_parameters.hpp"
#include "pose_messages.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/frame.hpp"
#include "wend_nav2/path_follower.hpp"

namespace wend_nav2 {
namespace {

[[noreturn]] void throw_as_nav2(const ControlFailure& failure) {
  switch (failure.kind) {
    case ControlFailureKind::invalid_path:
      throw nav2_core::InvalidPath(failure.message);
    case ControlFailureKind::no_progress:
      throw nav2_core::FailedToMakeProgress(failure.message);
    case ControlFailureKind::no_valid_control:
      throw nav2_core::NoValidControl(failure.message);
    case ControlFailureKind::old_pose:
      throw nav2_core::ControllerTFError(failure.message);
    case ControlFailureKind::other:
      break;
  }
  throw nav2_core::ControllerException(failure.message);
}

/// The angle of a turn about z, up to two half turns, which goal checkers use as a tolerance.
double angle_of(const geometry_msgs::msg::Quaternion& turn) {
  return 2 * std::atan2(std::abs(turn.z), turn.w);
}

}  // namespace

class Controller final : public nav2_core::Controller {
 public:
  void configure(const Node::WeakPtr& parent, std::string name, TransformBuffer transforms,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) override {
    const auto node = parent.lock();
    if (!node) throw std::runtime_error(name + ": the node is gone");
    name_ = std::move(name);
    logger_ = node->get_logger();
    clock_ = node->get_clock();
    transforms_ = std::move(transforms);
    costmap_ = std::move(costmap);
    double frequency = 20;
    node->get_parameter("controller_frequency", frequency);
    if (!(frequency > 0)) throw std::runtime_error(name_ + ": controller_frequency: must be > 0");
    period_ = 1 / frequency;
    follower_.emplace();
    parameters_ = std::make_unique<PluginParameters>(node->get_node_parameters_interface(), name_);
    const ControllerSchema of_all = controller_schema("");
    chosen_ = parameters_->fixed(of_all.name.name, of_all.name.default_value, of_all.name.help);
    const ControllerSchema schema = controller_schema(chosen_);
    for (const auto* options : {&schema.plugin, &schema.robot, &schema.follower}) {
      parameters_->declare(*options);
    }
    apply(parameters_->declare(schema.controller));
    RCLCPP_INFO(node->get_logger(), "%s follows with wend's %s", name_.c_str(), chosen_.c_str());
  }

  void activate() override {
    parameters_->watch([this](const wend::OptionValues& values) {
      const auto settings = control_settings_from(chosen_, values);
      return settings ? std::string() : settings.error().message;
    });
  }

  void deactivate() override { parameters_->stop_watching(); }

  void cleanup() override {
    const std::lock_guard lock(following_);
    parameters_.reset();
    follower_.reset();
    costmap_.reset();
    transforms_.reset();
  }

  void setPlan(const nav_msgs::msg::Path& path) override {
    const std::lock_guard lock(following_);
    if (path.header.frame_id != frame_ && follower_) follower_->forget_path();
    frame_ = path.header.frame_id;
    new_path_ = poses_from(path);
  }

  geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker) override {
    const std::lock_guard lock(following_);
    if (!follower_) throw nav2_core::ControllerException(name_ + " is not configured");
    if (const auto values = parameters_->changed()) apply(*values);
    if (new_path_) begin(*std::exchange(new_path_, {}), goal_checker);
    const wend::MapPose in_costmap = checked(pose);
    const ControlMoment moment{.on_path = in_frame_of_path(in_costmap, pose.header.frame_id),
                               .in_costmap = in_costmap,
                               .velocity = {velocity.linear.x, velocity.angular.z},
                               .robot = robot(),
                               .seconds = period_,
                               .age = age_of(pose.header.stamp)};
    read(*costmap_->getCostmap(), costmap_->getGlobalFrameID(), follower_->costmap());
    const auto command = follower_->command(moment);
    if (!command) throw_as_nav2(command.error());
    geometry_msgs::msg::TwistStamped message;
    message.header.frame_id = costmap_->getBaseFrameID();
    message.header.stamp = clock_->now();
    message.twist.linear.x = command->linear;
    message.twist.angular.z = command->angular;
    return message;
  }

  bool cancel() override {
    const std::lock_guard lock(following_);
    return !follower_ || follower_->stop();
  }

  void setSpeedLimit(const double& speed_limit, const bool& percentage) override {
    const std::lock_guard lock(following_);
    if (!follower_) return;
    const bool taken = percentage ? follower_->set_speed_limit_percent(speed_limit)
                                  : follower_->set_speed_limit(speed_limit);
    if (!taken) {
      RCLCPP_WARN(logger_, "%s: a speed limit of %g is ignored: a finite number from 0 on expected",
                  name_.c_str(), speed_limit);
    }
  }

  void reset() override {
    const std::lock_guard lock(following_);
    new_path_.reset();
    if (follower_) follower_->reset();
  }

 private:
  void apply(const wend::OptionValues& values) {
    auto settings = control_settings_from(chosen_, values);
    if (!settings) throw std::runtime_error(name_ + ": " + settings.error().message);
    follower_->set(*std::move(settings));
  }

  void begin(const wend::Expected<std::vector<wend::MapPose>, std::string>& path,
             nav2_core::GoalChecker* goal_checker) {
    if (!path) {
      follower_->forget_path();
      throw nav2_core::InvalidPath(path.error());
    }
    geometry_msgs::msg::Pose tolerance;
    geometry_msgs::msg::Twist of_velocity;
    if (goal_checker != nullptr && goal_checker->getTolerances(tolerance, of_velocity)) {
      const double angle = angle_of(tolerance.orientation);
      follower_->set_goal_tolerance(tolerance.position.x, angle < wend::kPi ? angle : 0);
    }
    const auto taken = follower_->set_path(*path);
    if (!taken) throw_as_nav2(taken.error());
  }

  /// The robot may stand on a slope.
  static wend::MapPose checked(const geometry_msgs::msg::PoseStamped& pose) {
    const auto taken = pose_from(pose.pose, Tilt::slope);
    if (!taken) throw nav2_core::ControllerException("the robot's pose: " + taken.error());
    return *taken;
  }

  /// In seconds; 0 of a pose without a stamp, as static transforms have none.
  double age_of(const builtin_interfaces::msg::Time& stamp) const {
    const rclcpp::Time then(stamp, clock_->get_clock_type());
    return then.nanoseconds() == 0 ? 0 : (clock_->now() - then).seconds();
  }

  /// The newest transform: the frame of the path moves little within a period.
  wend::MapPose in_frame_of_path(const wend::MapPose& pose, const std::string& frame) const {
    if (frame_.empty() || frame_ == frame) return pose;
    try {
      const wend::Frame from{
          .resolution = 1,
          .origin =
              pose_from(transforms_->lookupTransform(frame_, frame, tf2::TimePointZero).transform)};
      return from.to_metres(wend::Pose{pose.x, pose.y, pose.heading});
    } catch (const tf2::TransformException& error) {
      throw nav2_core::ControllerTFError(error.what());
    }
  }

  RobotShape robot() {
    const auto shape = robot_of(costmap_);
    if (!shape) throw nav2_core::ControllerException(shape.error().message);
    return *shape;
  }

  std::string name_;
  rclcpp::Logger logger_{rclcpp::get_logger("wend_nav2")};
  rclcpp::Clock::SharedPtr clock_;
  TransformBuffer transforms_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  double period_ = 0.05;  // s
  std::string chosen_;
  std::unique_ptr<PluginParameters> parameters_;
  std::mutex following_;
  std::optional<PathFollower> follower_;
  std::string frame_;  // of the path
  std::optional<wend::Expected<std::vector<wend::MapPose>, std::string>> new_path_;
};

}  // namespace wend_nav2

PLUGINLIB_EXPORT_CLASS(wend_nav2::Controller, nav2_core::Controller)
