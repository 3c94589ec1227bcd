// SPDX-License-Identifier: Apache-2.0
//
// wend_nav2/Smoother: wend's smoothers as a smoother of Nav2. The path that it gives is free if the one that it took is;
// one that is not is refused as InvalidPath.
//
//   smoother_server:
//     ros__parameters:
//       smoother_plugins: ["safe"]
//       safe:
//         plugin: "wend_nav2::Smoother"
//         smoother: "gradient"

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nav2_core/smoother.hpp>
#include <nav2_core/smoother_exceptions.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "conversions.hpp"
#include "nav2_types.hpp"
#include "plugin_parameters.hpp"
#include "pose_messages.hpp"
#include "wend_nav2/path_smoother.hpp"

namespace wend_nav2 {
namespace {

[[noreturn]] void throw_as_nav2(const Failure& failure) {
  switch (failure.kind) {
    case FailureKind::no_valid_path:
      throw nav2_core::InvalidPath(failure.message);
    case FailureKind::invalid_planner:
      throw nav2_core::InvalidSmoother(failure.message);
    default:
      throw nav2_core::FailedToSmoothPath(failure.message);
  }
}

}  // namespace

class Smoother final : public nav2_core::Smoother {
 public:
  void configure(const Node::WeakPtr& parent, std::string name, TransformBuffer,
                 std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap,
                 std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint) override {
    const auto node = parent.lock();
    if (!node) throw std::runtime_error(name + ": the node is gone");
    name_ = std::move(name);
    costmap_ = std::move(costmap);
    footprint_ = std::move(footprint);
    smoother_.emplace();
    parameters_ = std::make_unique<PluginParameters>(node->get_node_parameters_interface(), name_);
    const SmootherSchema of_all = smoother_schema("");
    chosen_ = parameters_->fixed(of_all.name.name, of_all.name.default_value, of_all.name.help);
    const SmootherSchema schema = smoother_schema(chosen_);
    parameters_->declare(schema.plugin);
    apply(parameters_->declare(schema.smoother));
    RCLCPP_INFO(node->get_logger(), "%s smooths with wend's %s", name_.c_str(), chosen_.c_str());
  }

  void activate() override {
    parameters_->watch([this](const wend::OptionValues& values) {
      const auto settings = smoother_settings_from(chosen_, values);
      return settings ? std::string() : settings.error().message;
    });
  }

  void deactivate() override { parameters_->stop_watching(); }

  void cleanup() override {
    const std::lock_guard lock(smoothing_);
    parameters_.reset();
    smoother_.reset();
    costmap_.reset();
    footprint_.reset();
  }

  bool smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) override {
    const std::lock_guard lock(smoothing_);
    if (!smoother_) throw nav2_core::SmootherException(name_ + " is not configured");
    const auto begin = std::chrono::steady_clock::now();
    const std::chrono::nanoseconds limit(max_time.nanoseconds());
    if (const auto values = parameters_->changed()) apply(*values);
    const RobotShape shape = robot();
    read_costmap(path.header.frame_id);
    const auto poses = poses_from(path);
    if (!poses) throw nav2_core::InvalidPath(poses.error());
    auto smoothed = smoother_->smooth(
        *poses, shape, [&] { return std::chrono::steady_clock::now() - begin > limit; });
    if (!smoothed) throw_as_nav2(smoothed.error());
    path = to_message(smoothed->poses, path.header);
    return smoothed->complete;
  }

 private:
  void apply(const wend::OptionValues& values) {
    auto settings = smoother_settings_from(chosen_, values);
    if (!settings) throw std::runtime_error(name_ + ": " + settings.error().message);
    smoother_->set(*std::move(settings));
  }

  void read_costmap(const std::string& frame) {
    try {
      const auto costmap = costmap_->getCostmap();
      read(*costmap, frame, smoother_->costmap());
    } catch (const std::runtime_error& error) {
      throw nav2_core::FailedToSmoothPath(error.what());
    }
  }

  RobotShape robot() {
    std::vector<geometry_msgs::msg::Point> corners;
    std_msgs::msg::Header header;
    if (!footprint_->getFootprintInRobotFrame(corners, header)) {
      throw nav2_core::FailedToSmoothPath("no footprint has come yet");
    }
    const auto footprint = footprint_from(corners);
    if (!footprint) throw nav2_core::FailedToSmoothPath(footprint.error().message);
    return {*footprint, true};
  }

  std::string name_;
  std::string chosen_;
  std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_;
  std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_;
  std::unique_ptr<PluginParameters> parameters_;
  std::mutex smoothing_;
  std::optional<PathSmoother> smoother_;
};

}  // namespace wend_nav2

PLUGINLIB_EXPORT_CLASS(wend_nav2::Smoother, nav2_core::Smoother)
