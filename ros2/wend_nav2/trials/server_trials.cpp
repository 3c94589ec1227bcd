// SPDX-License-Identifier: Apache-2.0
//
// server_trials: one request to Nav2's servers, as an action client sees the answer. Poses are x,y,heading in the frame
// `map`.
//
//   server_trials plan PLANNER START GOAL [CANCEL_AFTER]      ComputePathToPose; cancelled after so many seconds
//   server_trials through PLANNER START GOAL GOAL...          ComputePathThroughPoses
//   server_trials smooth PLANNER SMOOTHER START GOAL          plans, then SmoothPath
//   server_trials follow PLANNER CONTROLLER START GOAL [CANCEL_AFTER]    plans, then FollowPath
//   server_trials set NODE PARAMETER VALUE                    a number, true or false, or text
//
// Prints one line: what came of it, Nav2's error code, the length of the path and seconds.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <nav2_msgs/action/compute_path_through_poses.hpp>
#include <nav2_msgs/action/compute_path_to_pose.hpp>
#include <nav2_msgs/action/follow_path.hpp>
#include <nav2_msgs/action/smooth_path.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>

#include "../src/pose_messages.hpp"
#include "outcome.hpp"

namespace {

using nav2_msgs::action::ComputePathThroughPoses;
using nav2_msgs::action::ComputePathToPose;
using nav2_msgs::action::FollowPath;
using nav2_msgs::action::SmoothPath;
using Names = std::vector<std::string>;

constexpr std::chrono::seconds kPatience(120);

const Names kOfPlanner{
    "UNKNOWN",        "INVALID_PLANNER", "TF_ERROR", "START_OUTSIDE_MAP", "GOAL_OUTSIDE_MAP",
    "START_OCCUPIED", "GOAL_OCCUPIED",   "TIMEOUT",  "NO_VALID_PATH",     "NO_VIAPOINTS_GIVEN"};
const Names kOfSmoother{"UNKNOWN",
                        "INVALID_SMOOTHER",
                        "TIMEOUT",
                        "SMOOTHED_PATH_IN_COLLISION",
                        "FAILED_TO_SMOOTH_PATH",
                        "INVALID_PATH"};
const Names kOfController{"UNKNOWN",          "INVALID_CONTROLLER",  "TF_ERROR",
                          "INVALID_PATH",     "PATIENCE_EXCEEDED",   "FAILED_TO_MAKE_PROGRESS",
                          "NO_VALID_CONTROL", "CONTROLLER_TIMED_OUT"};

/// Nav2's codes count from a hundred of each action.
std::string name_of(unsigned code, const Names& names) {
  if (code == 0) return "NONE";
  return code % 100 < names.size() ? names[code % 100] : std::to_string(code);
}

std::string name_of(rclcpp_action::ResultCode code) {
  switch (code) {
    case rclcpp_action::ResultCode::SUCCEEDED:
      return "SUCCEEDED";
    case rclcpp_action::ResultCode::ABORTED:
      return "ABORTED";
    case rclcpp_action::ResultCode::CANCELED:
      return "CANCELED";
    default:
      return "UNKNOWN";
  }
}

geometry_msgs::msg::PoseStamped pose_from(const std::string& text) {
  wend::MapPose pose;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf", &pose.x, &pose.y, &pose.heading) != 3) {
    throw std::runtime_error("'" + text + "': a pose is x,y,heading");
  }
  geometry_msgs::msg::PoseStamped message;
  message.header.frame_id = "map";
  message.pose = wend_nav2::to_message(pose);
  return message;
}

template <class Action>
struct Answer {
  typename rclcpp_action::ClientGoalHandle<Action>::WrappedResult wrapped;
  double seconds = 0;
};

class Client {
  template <class Future>
  auto wait(Future future, std::chrono::seconds limit) {
    if (rclcpp::spin_until_future_complete(node_, future, limit) !=
        rclcpp::FutureReturnCode::SUCCESS) {
      throw std::runtime_error("no answer");
    }
    return future.get();
  }

 public:
  Client() : node_(std::make_shared<rclcpp::Node>("server_trials")) {}

  /// Cancels after so many seconds, if that is not negative.
  template <class Action>
  Answer<Action> call(const std::string& name, const typename Action::Goal& goal,
                      double cancel_after = -1) {
    const auto client = rclcpp_action::create_client<Action>(node_, name);
    if (!client->wait_for_action_server(kPatience)) throw std::runtime_error(name + ": no server");
    const auto begin = std::chrono::steady_clock::now();
    const auto handle = wait(client->async_send_goal(goal), kPatience);
    if (!handle) throw std::runtime_error(name + ": the goal was rejected");
    auto result = client->async_get_result(handle);
    if (cancel_after >= 0) {
      const std::chrono::duration<double> after(cancel_after);
      const auto early = rclcpp::spin_until_future_complete(node_, result, after);
      if (early != rclcpp::FutureReturnCode::SUCCESS) client->async_cancel_goal(handle);
    }
    const auto wrapped = wait(result, kPatience);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    return {wrapped, took.count()};
  }

  void set(const std::string& node, const rclcpp::Parameter& parameter) {
    rclcpp::AsyncParametersClient client(node_, node);
    if (!client.wait_for_service(kPatience)) throw std::runtime_error(node + ": no such node");
    const auto results = wait(client.set_parameters({parameter}), kPatience);
    std::printf("set %s %s\n",
                results.front().successful ? "done" : "refused:", results.front().reason.c_str());
  }

 private:
  rclcpp::Node::SharedPtr node_;
};

template <class Action>
void report(const std::string& what, const Answer<Action>& answer, const Names& names,
            const nav_msgs::msg::Path& path) {
  const auto& result = *answer.wrapped.result;
  std::printf("%s %s %s poses %zu length %.2f m in %.4f s %s\n", what.c_str(),
              name_of(answer.wrapped.code).c_str(), name_of(result.error_code, names).c_str(),
              path.poses.size(), wend_nav2::trials::length_of(path), answer.seconds,
              result.error_msg.c_str());
}

Answer<ComputePathToPose> plan(Client& client, std::span<const std::string> arguments,
                               double cancel_after = -1) {
  ComputePathToPose::Goal goal;
  goal.planner_id = arguments[0];
  goal.start = pose_from(arguments[1]);
  goal.goal = pose_from(arguments[2]);
  goal.use_start = true;
  auto answer = client.call<ComputePathToPose>("compute_path_to_pose", goal, cancel_after);
  report("plan " + arguments[0], answer, kOfPlanner, answer.wrapped.result->path);
  return answer;
}

void plan_through(Client& client, std::span<const std::string> arguments) {
  ComputePathThroughPoses::Goal goal;
  goal.planner_id = arguments[0];
  goal.start = pose_from(arguments[1]);
  for (const std::string& stop : arguments.subspan(2)) goal.goals.push_back(pose_from(stop));
  goal.use_start = true;
  const auto answer = client.call<ComputePathThroughPoses>("compute_path_through_poses", goal);
  report("through " + arguments[0], answer, kOfPlanner, answer.wrapped.result->path);
}

void smooth(Client& client, std::span<const std::string> arguments) {
  const std::vector<std::string> of_plan{arguments[0], arguments[2], arguments[3]};
  SmoothPath::Goal goal;
  goal.path = plan(client, of_plan).wrapped.result->path;
  goal.smoother_id = arguments[1];
  goal.max_smoothing_duration.sec = 5;
  goal.check_for_collisions = true;
  const auto answer = client.call<SmoothPath>("smooth_path", goal);
  report("smooth " + arguments[1], answer, kOfSmoother, answer.wrapped.result->path);
}

void follow(Client& client, std::span<const std::string> arguments) {
  const std::vector<std::string> of_plan{arguments[0], arguments[2], arguments[3]};
  FollowPath::Goal goal;
  goal.path = plan(client, of_plan).wrapped.result->path;
  goal.controller_id = arguments[1];
  const double cancel_after = arguments.size() > 4 ? std::stod(arguments[4]) : -1;
  const auto answer = client.call<FollowPath>("follow_path", goal, cancel_after);
  report("follow " + arguments[1], answer, kOfController, goal.path);
}

rclcpp::Parameter parameter_from(const std::string& name, const std::string& value) {
  if (value == "true" || value == "false") return {name, value == "true"};
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (end != value.c_str() && *end == '\0') return {name, number};
  return {name, value};
}

struct Command {
  std::string name;
  std::size_t least;  // arguments
  std::function<void(Client&, std::span<const std::string>)> run;
};

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"plan", 3,
       [](Client& client, std::span<const std::string> given) {
         plan(client, given, given.size() > 3 ? std::stod(given[3]) : -1);
       }},
      {"through", 3, plan_through},
      {"smooth", 4, smooth},
      {"follow", 4, follow},
      {"set", 3, [](Client& client, std::span<const std::string> given) {
         client.set(given[0], parameter_from(given[1], given[2]));
       }}};
  return all;
}

int run(const std::vector<std::string>& arguments) {
  for (const Command& command : commands()) {
    if (arguments.size() < 2 || arguments[1] != command.name) continue;
    const auto given = std::span(arguments).subspan(2);
    if (given.size() < command.least) break;
    Client client;
    command.run(client, given);
    return 0;
  }
  std::fprintf(stderr, "server_trials plan|through|smooth|follow|set ...: see the source\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int code = run(rclcpp::init_and_remove_ros_arguments(argc, argv));
    rclcpp::shutdown();
    return code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "server_trials: %s\n", error.what());
    return 1;
  }
}
