// SPDX-License-Identifier: Apache-2.0
//
// wend_nav2/Planner: wend's planners as a global planner of Nav2.
//
//   planner_server:
//     ros__parameters:
//       planner_plugins: ["GridBased"]
//       GridBased:
//         plugin: "wend_nav2::Planner"
//         planner: "astar"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nav2_core/global_planner.hpp>
#include <nav2_core/planner_exceptions.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "conversions.hpp"
#include "nav2_types.hpp"
#include "plugin_parameters.hpp"
#include "pose_messages.hpp"
#include "wend/io/text.hpp"
#include "wend_nav2/path_planner.hpp"

namespace wend_nav2 {
namespace {

[[noreturn]] void throw_as_nav2(const Failure& failure) {
  switch (failure.kind) {
    case FailureKind::invalid_planner:
      throw nav2_core::InvalidPlanner(failure.message);
    case FailureKind::tf_error:
      throw nav2_core::PlannerTFError(failure.message);
    case FailureKind::start_outside:
      throw nav2_core::StartOutsideMapBounds(failure.message);
    case FailureKind::goal_outside:
      throw nav2_core::GoalOutsideMapBounds(failure.message);
    case FailureKind::start_occupied:
      throw nav2_core::StartOccupied(failure.message);
    case FailureKind::goal_occupied:
      throw nav2_core::GoalOccupied(failure.message);
    case FailureKind::timed_out:
      throw nav2_core::PlannerTimedOut(failure.message);
    case FailureKind::no_valid_path:
      throw nav2_core::NoValidPathCouldBeFound(failure.message);
    case FailureKind::cancelled:
      throw nav2_core::PlannerCancelled(failure.message);
    case FailureKind::other:
      break;
  }
  throw nav2_core::PlannerException(failure.message);
}

}  // namespace

class Planner final : public nav2_core::GlobalPlanner {
 public:
  using Pose = geometry_msgs::msg::PoseStamped;
  using Path = nav_msgs::msg::Path;

  void configure(const Node::WeakPtr& parent, std::string name, TransformBuffer,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap) override {
    const auto node = parent.lock();
    if (!node) throw std::runtime_error(name + ": the node is gone");
    name_ = std::move(name);
    logger_ = node->get_logger();
    clock_ = node->get_clock();
    costmap_ = std::move(costmap);
    planner_.emplace();
    parameters_ = std::make_unique<PluginParameters>(node->get_node_parameters_interface(), name_);
    read_parameters();
    RCLCPP_INFO(logger_, "%s plans with wend's %s", name_.c_str(),
                planner_->settings().planner.c_str());
  }

  void activate() override {
    parameters_->watch([this](const wend::OptionValues& values) {
      const auto settings = settings_from(planner_name_, values, primitives_);
      return settings ? std::string() : settings.error().message;
    });
  }

  void deactivate() override { parameters_->stop_watching(); }

  void cleanup() override {
    const std::lock_guard lock(planning_);
    parameters_.reset();
    planner_.reset();
    costmap_.reset();
  }

#if WEND_NAV2_VIAPOINTS
  Path createPlan(const Pose& start, const Pose& goal, const std::vector<Pose>& viapoints,
                  std::function<bool()> cancelled) override {
    std::vector<Pose> stops{start};
    stops.insert(stops.end(), viapoints.begin(), viapoints.end());
    stops.push_back(goal);
    return plan_through(stops, cancelled);
  }
#else
  Path createPlan(const Pose& start, const Pose& goal, std::function<bool()> cancelled) override {
    return plan_through({start, goal}, cancelled);
  }
#endif

 private:
  void read_parameters() {
    const PlannerSchema of_all = planner_schema("");
    planner_name_ =
        parameters_->fixed(of_all.name.name, of_all.name.default_value, of_all.name.help);
    primitives_ = parameters_->fixed(std::string(kPrimitivesParameter), "",
                                     "file of the robot's motion primitives, for lattice");
    const PlannerSchema schema = planner_schema(planner_name_);
    parameters_->declare(schema.plugin);
    apply(parameters_->declare(schema.planner));
  }

  void apply(const wend::OptionValues& values) {
    auto settings = settings_from(planner_name_, values, primitives_);
    if (!settings) throw std::runtime_error(name_ + ": " + settings.error().message);
    planner_->set(*std::move(settings));
  }

  Path plan_through(const std::vector<Pose>& stops, const std::function<bool()>& cancelled) {
    const std::lock_guard lock(planning_);
    if (!planner_) throw nav2_core::PlannerException(name_ + " is not configured");
    if (const auto values = parameters_->changed()) apply(*values);
    const std::string frame = costmap_->getGlobalFrameID();
    for (const Pose& stop : stops) check_frame(stop, frame);
    PathRequest request{.robot = robot()};
    read(*costmap_->getCostmap(), frame, planner_->costmap());
    PathPlanner::Poses all;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      // A leg begins where the one before ended, which may be near a stop that cannot be reached.
      request.start = all.empty() ? checked("the start", stops[i], Tilt::slope) : all.back();
      request.goal = checked("the goal", stops[i + 1], Tilt::flat);
      const auto leg = planner_->plan(request, cancelled);
      if (!leg) throw_as_nav2(leg.error());
      tell_shifts(planner_->shifts());
      all.insert(all.end(), leg->begin() + (all.empty() ? 0 : 1), leg->end());
    }
    std_msgs::msg::Header header;
    header.frame_id = frame;
    header.stamp = clock_->now();
    return to_message(all, header);
  }

  /// Once, and not for every path that a robot asks for on its way.
  void tell_shifts(const std::string& shifts) {
    if (!shifts.empty() && shifts != told_)
      RCLCPP_INFO(logger_, "%s: %s", name_.c_str(), shifts.c_str());
    told_ = shifts;
  }

  void check_frame(const Pose& pose, const std::string& frame) const {
    const std::string& given = pose.header.frame_id;
    if (given.empty() || given == frame) return;
    throw nav2_core::PlannerTFError("a pose in the frame " + wend::quote(given) + ", " +
                                    wend::quote(frame) + " expected");
  }

  static wend::MapPose checked(const std::string& name, const Pose& stop, Tilt tilt) {
    const auto pose = pose_from(stop.pose, tilt);
    if (!pose) throw nav2_core::PlannerException(name + ": " + pose.error());
    return *pose;
  }

  RobotShape robot() {
    const auto shape = robot_of(costmap_);
    if (!shape) throw nav2_core::PlannerException(shape.error().message);
    return *shape;
  }

  std::string name_;
  std::string told_;  // how far ends were moved
  rclcpp::Logger logger_{rclcpp::get_logger("wend_nav2")};
  rclcpp::Clock::SharedPtr clock_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_;
  std::string planner_name_;
  std::string primitives_;
  std::unique_ptr<PluginParameters> parameters_;
  std::mutex planning_;
  std::optional<PathPlanner> planner_;
};

}  // namespace wend_nav2

PLUGINLIB_EXPORT_CLASS(wend_nav2::Planner, nav2_core::GlobalPlanner)
