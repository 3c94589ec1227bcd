// SPDX-License-Identifier: Apache-2.0
//
// planner_server: wend's planners as a node, for robots without Nav2.
//
//   ros2 run wend_ros planner_server --ros-args -p planner:=astar -p robot_radius:=0.2
//
// Topics in: map (transient local), map_updates, goal_pose (plans from the robot's own pose, as rviz asks for it).
// Topics out: plan, markers. Service and action: plan_path. Parameters: planner, primitives, and the options of
// wend_nav2/Planner and of the planner by their names; robot_radius (m), footprint (corners x1, y1, x2, y2, ... in
// metres, or a text such as "rect:0.8x0.5,0.2", instead of a radius), occupied_from, robot_frame.

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tf2/exceptions.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <map_msgs/msg/occupancy_grid_update.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include <wend_ros/action/plan_path.hpp>
#include <wend_ros/srv/plan_path.hpp>

#include "plan_messages.hpp"
#include "plugin_parameters.hpp"
#include "pose_messages.hpp"
#include "wend_nav2/path_planner.hpp"
#include "wend_ros/node_settings.hpp"
#include "wend_ros/occupancy_costs.hpp"

namespace wend_ros {
namespace {

using geometry_msgs::msg::PoseStamped;
using wend_nav2::Failure;
using wend_nav2::FailureKind;
using wend_nav2::PathPlanner;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

wend::Unexpected<Failure> tf_failure(const std::string& message) {
  return wend::Unexpected<Failure>(Failure{FailureKind::tf_error, message});
}

/// A parameter that stays as it is while the node runs.
rclcpp::ParameterValue fixed(rclcpp::Node& node, const std::string& name,
                             const rclcpp::ParameterValue& default_value, const std::string& help) {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = help;
  descriptor.read_only = true;
  descriptor.dynamic_typing = true;  // "robot_radius: 1" is a whole number to YAML
  return node.declare_parameter(name, default_value, descriptor);
}

[[noreturn]] void refuse(const std::string& name, const rclcpp::ParameterValue& value) {
  throw std::runtime_error("option '" + name + "': '" + rclcpp::to_string(value) +
                           "' is of another type than expected");
}

double number_of(const std::string& name, const rclcpp::ParameterValue& value) {
  switch (value.get_type()) {
    case rclcpp::ParameterType::PARAMETER_INTEGER:
      return static_cast<double>(value.get<std::int64_t>());
    case rclcpp::ParameterType::PARAMETER_DOUBLE:
      return value.get<double>();
    default:
      refuse(name, value);
  }
}

std::vector<double> numbers_of(const std::string& name, const rclcpp::ParameterValue& value) {
  switch (value.get_type()) {
    case rclcpp::ParameterType::PARAMETER_INTEGER_ARRAY: {
      const auto& whole = value.get<std::vector<std::int64_t>>();
      return {whole.begin(), whole.end()};
    }
    case rclcpp::ParameterType::PARAMETER_DOUBLE_ARRAY:
      return value.get<std::vector<double>>();
    default:
      refuse(name, value);
  }
}

NodeSettings settings_of(rclcpp::Node& node) {
  const NodeSettings defaults;
  const auto value = [&](const std::string& name, const auto& default_value,
                         const std::string& help) {
    return fixed(node, name, rclcpp::ParameterValue(default_value), help);
  };
  const auto radius = value("robot_radius", defaults.robot_radius, "radius of the robot, m");
  const auto corners = value(
      "footprint", defaults.footprint,
      "corners x1, y1, x2, y2, ... in metres, or a text such as rect:0.8x0.5,0.2, in place of "
      "the radius");
  const auto occupied = value("occupied_from", defaults.occupied_from,
                              "values of the map from here on are obstacles");
  const auto frame = value("robot_frame", defaults.robot_frame, "frame of the robot");
  if (occupied.get_type() != rclcpp::ParameterType::PARAMETER_INTEGER) {
    refuse("occupied_from", occupied);
  }
  if (frame.get_type() != rclcpp::ParameterType::PARAMETER_STRING) refuse("robot_frame", frame);
  const bool written = corners.get_type() == rclcpp::ParameterType::PARAMETER_STRING;
  return {.robot_radius = number_of("robot_radius", radius),
          .footprint = written ? std::vector<double>{} : numbers_of("footprint", corners),
          .shape = written ? corners.get<std::string>() : std::string(),
          .occupied_from = occupied.get<std::int64_t>(),
          .robot_frame = frame.get<std::string>()};
}

class PlannerServer : public rclcpp::Node {
 public:
  using Service = srv::PlanPath;
  using Action = action::PlanPath;
  using Goal = rclcpp_action::ServerGoalHandle<Action>;

  PlannerServer()
      : Node("planner_server"),
        parameters_(get_node_parameters_interface(), ""),
        transforms_(get_clock()) {
    read_settings();
    read_parameters();
    // A listener that goes before it has spun, as one that throws leaves it behind, waits for ever.
    listener_.emplace(transforms_);
    publish_and_subscribe();
    serve();
    RCLCPP_INFO(get_logger(), "plans with wend's %s", planner_name_.c_str());
  }

 private:
  void read_settings() {
    const NodeSettings settings = settings_of(*this);
    const auto footprint = robot_from(settings);
    if (!footprint) throw std::runtime_error(footprint.error().message);
    robot_ = {*footprint, false};
    robot_frame_ = settings.robot_frame;
    map_ = OccupancyCosts(static_cast<int>(settings.occupied_from));
  }

  void read_parameters() {
    const wend_nav2::PlannerSchema of_all = wend_nav2::planner_schema("");
    planner_name_ =
        parameters_.fixed(of_all.name.name, of_all.name.default_value, of_all.name.help);
    primitives_ = parameters_.fixed(std::string(wend_nav2::kPrimitivesParameter), "",
                                    "file of the robot's motion primitives, for lattice");
    const wend_nav2::PlannerSchema schema = wend_nav2::planner_schema(planner_name_);
    parameters_.declare(schema.plugin);
    apply(parameters_.declare(schema.planner));
    parameters_.watch([this](const wend::OptionValues& values) {
      const auto settings = wend_nav2::settings_from(planner_name_, values, primitives_);
      return settings ? std::string() : settings.error().message;
    });
  }

  void apply(const wend::OptionValues& values) {
    auto settings = wend_nav2::settings_from(planner_name_, values, primitives_);
    if (!settings) throw std::runtime_error(settings.error().message);
    planner_.set(*std::move(settings));
  }

  void publish_and_subscribe() {
    const auto latched = rclcpp::QoS(1).transient_local().reliable();
    paths_ = create_publisher<nav_msgs::msg::Path>("plan", latched);
    markers_ = create_publisher<visualization_msgs::msg::MarkerArray>("markers", latched);
    maps_ = create_subscription<nav_msgs::msg::OccupancyGrid>(
        "map", latched, [this](const nav_msgs::msg::OccupancyGrid& map) {
          const std::lock_guard lock(map_mutex_);
          take(map);
        });
    updates_ = create_subscription<map_msgs::msg::OccupancyGridUpdate>(
        "map_updates", rclcpp::QoS(10), [this](const map_msgs::msg::OccupancyGridUpdate& update) {
          const std::lock_guard lock(map_mutex_);
          warn_unless(map_.take(update_of(update)));
        });
    calls_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    rclcpp::SubscriptionOptions options;
    options.callback_group = calls_;
    goals_ = create_subscription<PoseStamped>(
        "goal_pose", 1,
        [this](const PoseStamped& goal) {
          Service::Request request;
          request.goal = goal;
          answer<Service::Response>(request, {});
        },
        options);
  }

  /// A map that is none leaves no map.
  void take(const nav_msgs::msg::OccupancyGrid& map) {
    const auto layout = layout_of(map);
    if (layout) return warn_unless(map_.take(*layout, map.data));
    map_.clear();
    warn_unless(wend::Unexpected<wend::Error>(layout.error()));
  }

  void warn_unless(const wend::Expected<void, wend::Error>& taken) const {
    if (!taken) RCLCPP_WARN(get_logger(), "map rejected: %s", taken.error().message.c_str());
  }

  void serve() {
    service_ = create_service<Service>(
        "plan_path",
        [this](const Service::Request::SharedPtr request, Service::Response::SharedPtr response) {
          *response = answer<Service::Response>(*request, {});
        },
        rclcpp::ServicesQoS(), calls_);
    action_ = rclcpp_action::create_server<Action>(
        this, "plan_path",
        [](const rclcpp_action::GoalUUID&, std::shared_ptr<const Action::Goal>) {
          return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
        },
        [](const std::shared_ptr<Goal>&) { return rclcpp_action::CancelResponse::ACCEPT; },
        [this](const std::shared_ptr<Goal>& goal) { begin(goal); },
        rcl_action_server_get_default_options(), calls_);
  }

  /// A thread for each goal: the executor's own go on.
  void begin(const std::shared_ptr<Goal>& goal) {
    const std::lock_guard lock(running_mutex_);
    std::erase_if(running_, [](const std::future<void>& run) {
      return run.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    running_.push_back(std::async(std::launch::async, [this, goal] { execute(*goal); }));
  }

  void execute(Goal& goal) {
    const auto begin = Clock::now();
    auto told = begin;
    const auto is_cancelled = [&] {
      constexpr std::chrono::milliseconds kFeedbackPeriod(100);
      if (Clock::now() - told >= kFeedbackPeriod) {
        told = Clock::now();
        auto feedback = std::make_shared<Action::Feedback>();
        feedback->elapsed = seconds_since(begin);
        goal.publish_feedback(feedback);
      }
      return goal.is_canceling() || !rclcpp::ok();
    };
    const auto result =
        std::make_shared<Action::Result>(answer<Action::Result>(*goal.get_goal(), is_cancelled));
    if (!rclcpp::ok()) return;
    if (goal.is_canceling()) {
      goal.canceled(result);
    } else if (result->status == static_cast<std::uint16_t>(StatusCode::found)) {
      goal.succeed(result);
    } else {
      goal.abort(result);
    }
  }

  /// Plans, and publishes a path that is found.
  template <class Result, class Request>
  Result answer(const Request& request, const PathPlanner::CancelChecker& is_cancelled) {
    const auto begin = Clock::now();
    Result result;
    StatusCode code = StatusCode::found;
    const auto path =
        plan(request.use_start ? &request.start : nullptr, request.goal, is_cancelled);
    if (path) {
      result.path = *path;
      result.length = length_of(*path);
      paths_->publish(*path);
      markers_->publish(markers_of(*path));
    } else {
      code = path.error().code;
      result.reason = path.error().message;
      RCLCPP_WARN(get_logger(), "%s", result.reason.c_str());
    }
    result.status = static_cast<std::uint16_t>(code);
    result.status_name = to_string(code);
    result.seconds = seconds_since(begin);
    return result;
  }

  struct Refusal {
    StatusCode code;
    std::string message;
  };

  /// From the robot's own pose if there is no start.
  wend::Expected<nav_msgs::msg::Path, Refusal> plan(
      const PoseStamped* start, const PoseStamped& goal,
      const PathPlanner::CancelChecker& is_cancelled) {
    const auto refused = [](StatusCode code, std::string message) {
      return wend::Unexpected<Refusal>(Refusal{code, std::move(message)});
    };
    const std::lock_guard lock(planning_);
    if (const auto values = parameters_.changed()) apply(*values);
    std::string frame;
    {
      const std::lock_guard map_lock(map_mutex_);
      if (map_.empty()) return refused(StatusCode::no_map, "no valid map has come yet");
      planner_.costmap().read(map_.layout(), map_.costs());
      frame = map_.layout().frame_id;
    }
    const auto from = start == nullptr
                          ? robot_pose(frame)
                          : in_frame("the start", *start, wend_nav2::Tilt::slope, frame);
    if (!from) return refused(code_of(from.error().kind), from.error().message);
    const auto to = in_frame("the goal", goal, wend_nav2::Tilt::flat, frame);
    if (!to) return refused(code_of(to.error().kind), to.error().message);
    const auto poses = planner_.plan({*from, *to, robot_}, is_cancelled);
    if (!poses) return refused(code_of(poses.error().kind), poses.error().message);
    std_msgs::msg::Header header;
    header.frame_id = frame;
    header.stamp = now();
    return wend_nav2::to_message(*poses, header);
  }

  wend::Expected<wend::MapPose, Failure> in_frame(const std::string& name, const PoseStamped& pose,
                                                  wend_nav2::Tilt tilt,
                                                  const std::string& frame) const {
    const auto at = wend_nav2::pose_from(pose.pose, tilt);
    if (!at) {
      return wend::Unexpected<Failure>(Failure{FailureKind::other, name + ": " + at.error()});
    }
    if (pose.header.frame_id.empty() || pose.header.frame_id == frame) return *at;
    const auto origin = origin_of(pose.header.frame_id, frame);
    if (!origin) return origin;
    return wend::Frame{.resolution = 1, .origin = *origin}.to_metres(
        wend::Pose{at->x, at->y, at->heading});
  }

  wend::Expected<wend::MapPose, Failure> robot_pose(const std::string& frame) const {
    return origin_of(robot_frame_, frame);
  }

  /// Where the origin of a frame is in another one.
  wend::Expected<wend::MapPose, Failure> origin_of(const std::string& child,
                                                   const std::string& frame) const {
    try {
      return wend_nav2::pose_from(
          transforms_.lookupTransform(frame, child, tf2::TimePointZero).transform);
    } catch (const tf2::TransformException& error) {
      return tf_failure(error.what());
    }
  }

  OccupancyCosts map_;  // guarded by map_mutex_
  std::mutex map_mutex_;
  std::string robot_frame_;
  wend_nav2::RobotShape robot_;
  wend_nav2::PluginParameters parameters_;
  std::string planner_name_;
  std::string primitives_;
  PathPlanner planner_;  // guarded by planning_
  std::mutex planning_;
  tf2_ros::Buffer transforms_;
  std::optional<tf2_ros::TransformListener> listener_;
  rclcpp::CallbackGroup::SharedPtr calls_;
  rclcpp::Publisher<nav_msgs::msg::Path>::SharedPtr paths_;
  rclcpp::Publisher<visualization_msgs::msg::MarkerArray>::SharedPtr markers_;
  rclcpp::Subscription<nav_msgs::msg::OccupancyGrid>::SharedPtr maps_;
  rclcpp::Subscription<map_msgs::msg::OccupancyGridUpdate>::SharedPtr updates_;
  rclcpp::Subscription<PoseStamped>::SharedPtr goals_;
  rclcpp::Service<Service>::SharedPtr service_;
  rclcpp_action::Server<Action>::SharedPtr action_;
  std::mutex running_mutex_;
  std::vector<std::future<void>> running_;  // last: its threads use the rest
};

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  try {
    rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
    const auto node = std::make_shared<wend_ros::PlannerServer>();
    executor.add_node(node);
    executor.spin();
  } catch (const std::exception& error) {
    RCLCPP_FATAL(rclcpp::get_logger("planner_server"), "%s", error.what());
    return 2;
  }
  rclcpp::shutdown();
  return 0;
}
