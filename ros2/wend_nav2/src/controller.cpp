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
    frame_ = path.header.frame_id;
    new_path_.emplace();
    for (const auto& stamped : path.poses) new_path_->push_back(pose_from(stamped.pose));
  }

  geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker) override {
    const std::lock_guard lock(following_);
    if (!follower_) throw nav2_core::ControllerException(name_ + " is not configured");
    if (const auto values = parameters_->changed()) apply(*values);
    if (new_path_) begin(*std::exchange(new_path_, {}), goal_checker);
    ControlMoment moment{.on_path = in_frame_of_path(pose),
                         .in_costmap = pose_from(pose.pose),
                         .velocity = {velocity.linear.x, velocity.angular.z},
                         .robot = robot(),
                         .seconds = period_};
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
    if (percentage) {
      follower_->set_speed_limit_percent(speed_limit);
    } else {
      follower_->set_speed_limit(speed_limit);
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

  void begin(const std::vector<wend::MapPose>& path, nav2_core::GoalChecker* goal_checker) {
    geometry_msgs::msg::Pose tolerance;
    geometry_msgs::msg::Twist of_velocity;
    if (goal_checker != nullptr && goal_checker->getTolerances(tolerance, of_velocity)) {
      const double angle = angle_of(tolerance.orientation);
      follower_->set_goal_tolerance(tolerance.position.x, angle < wend::kPi ? angle : 0);
    }
    const auto taken = follower_->set_path(path);
    if (!taken) throw_as_nav2(taken.error());
  }

  /// The newest transform: the frame of the path moves little within a period.
  wend::MapPose in_frame_of_path(const geometry_msgs::msg::PoseStamped& pose) const {
    if (frame_.empty() || frame_ == pose.header.frame_id) return pose_from(pose.pose);
    try {
      const auto transform =
          transforms_->lookupTransform(frame_, pose.header.frame_id, tf2::TimePointZero);
      const wend::MapPose at = pose_from(pose.pose);
      const wend::Frame frame{.resolution = 1, .origin = pose_from(transform.transform)};
      return frame.to_metres(wend::Pose{at.x, at.y, at.heading});
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
  rclcpp::Clock::SharedPtr clock_;
  TransformBuffer transforms_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  double period_ = 0.05;  // s
  std::string chosen_;
  std::unique_ptr<PluginParameters> parameters_;
  std::mutex following_;
  std::optional<PathFollower> follower_;
  std::string frame_;  // of the path
  std::optional<std::vector<wend::MapPose>> new_path_;
};

}  // namespace wend_nav2

PLUGINLIB_EXPORT_CLASS(wend_nav2::Controller, nav2_core::Controller)
