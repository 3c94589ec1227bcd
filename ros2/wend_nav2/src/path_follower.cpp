// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_nav2/path_pieces.hpp"
#include "wend_nav2/safe_velocity.hpp"

namespace wend_nav2 {
namespace {

// Of the goal checker's tolerance: the robot stands well within it.
constexpr double kShareOfTolerance = 0.5;

bool is_finite(const wend::MapPose& pose) { return std::isfinite(pose.x + pose.y + pose.heading); }

wend::Unexpected<ControlFailure> no_command(ControlFailureKind kind, std::string message) {
  return wend::Unexpected<ControlFailure>(ControlFailure{kind, std::move(message)});
}

std::string place_of(const wend::MapPose& pose) {
  const auto centimetres = [](double metres) {
    return wend::format_number(std::round(metres * 100) / 100);
  };
  return "(" + centimetres(pose.x) + ", " + centimetres(pose.y) + ")";
}

}  // namespace

std::string_view to_string(ControlFailureKind kind) {
  switch (kind) {
    case ControlFailureKind::invalid_path:
      return "invalid_path";
    case ControlFailureKind::no_progress:
      return "no_progress";
    case ControlFailureKind::no_valid_control:
      return "no_valid_control";
    case ControlFailureKind::other:
      break;
  }
  return "other";
}

void PathFollower::set_goal_tolerance(double distance, double heading) {
  goal_distance_ = distance;
  goal_heading_ = heading;
}

void PathFollower::set_speed_limit(double speed) {
  speed_limit_ = std::max(speed, 0.0);
  speed_share_ = 1;
  limit_speed();
}

void PathFollower::set_speed_limit_percent(double percent) {
  speed_limit_ = 0;
  speed_share_ = percent > 0 ? std::min(percent / 100, 1.0) : 1;
  limit_speed();
}

wend::VelocityLimits PathFollower::limits() const {
  wend::VelocityLimits limits = settings_.robot.limits;
  limits.speed *= speed_share_;
  if (speed_limit_ > 0) limits.speed = std::min(limits.speed, speed_limit_);
  return limits;
}

void PathFollower::limit_speed() {
  if (follower_) follower_->set_limits(limits());
}

wend::Expected<void, ControlFailure> PathFollower::set_path(
    const std::vector<wend::MapPose>& path) {
  follower_.reset();
  stops_ = false;
  if (path.empty()) return no_command(ControlFailureKind::invalid_path, "the path has no poses");
  if (!std::ranges::all_of(path, is_finite)) {
    return no_command(ControlFailureKind::invalid_path,
                      "a pose of the path contains NaN or infinity");
  }
  auto controller = wend::make_controller(settings_.controller, settings_.options);
  if (!controller) return no_command(ControlFailureKind::other, controller.error().message);
  controller_ = *std::move(controller);
  wend::FollowerOptions options = settings_.follower;
  options.goal_tolerance = kShareOfTolerance * goal_distance_;
  options.heading_tolerance = kShareOfTolerance * goal_heading_;
  follower_.emplace(*controller_, limits(), options);
  follower_->follow(route_along(path));
  goal_ = path.back();
  follower_->set_velocity(told_);
  return {};
}

wend::Expected<wend::FreeSpace, ControlFailure> PathFollower::space(const RobotShape& robot) {
  const ObstacleRule rule = rule_for(settings_.plugin.obstacles, robot);
  session_.set_robot(robot_for(rule, robot, settings_.plugin.allow_unknown));
  const auto brought = costmap_.bring_to(session_, scale_for(rule, 0));
  if (!brought) return no_command(ControlFailureKind::other, brought.error().message);
  auto view = session_.view();
  if (!view) return no_command(ControlFailureKind::other, view.error().message);
  return std::move(view->space);
}

wend::Expected<wend::Velocity, ControlFailure> PathFollower::wanted(const ControlMoment& moment) {
  if (stops_) return wend::Velocity{};
  if (!follower_) return no_command(ControlFailureKind::invalid_path, "there is no path");
  const wend::FollowerStep step = follower_->step(moment.on_path, moment.seconds);
  switch (step.state) {
    case wend::FollowerState::stuck:
      // Nearer than the goal checker asks for it may be stuck.
      if (is_at_goal(moment.on_path)) return wend::Velocity{};
      return no_command(ControlFailureKind::no_progress,
                        "the robot at " + place_of(moment.on_path) +
                            " of the path's frame makes no progress, or cannot turn at the goal");
    case wend::FollowerState::off_path:
      return no_command(ControlFailureKind::invalid_path,
                        "the robot at " + place_of(moment.on_path) + " is farther than " +
                            wend::format_number(settings_.follower.off_path) + " m from the path");
    case wend::FollowerState::invalid:
      return no_command(ControlFailureKind::invalid_path,
                        "the path or the controller's command has a number that is not finite");
    case wend::FollowerState::driving:
    case wend::FollowerState::reached:
      break;
  }
  return step.command;
}

wend::Expected<wend::Velocity, ControlFailure> PathFollower::command(const ControlMoment& moment) {
  if (!is_finite(moment.on_path) || !is_finite(moment.in_costmap)) {
    told_ = {};
    return no_command(ControlFailureKind::other, "the robot's pose contains NaN or infinity");
  }
  if (std::exchange(begins_, false)) {
    told_ = moment.velocity;
    if (follower_) follower_->set_velocity(told_);
  }
  const wend::Velocity before = std::exchange(told_, {});
  auto want = wanted(moment);
  if (!want) return want;
  const auto free = space(moment.robot);
  if (!free) return wend::Unexpected<ControlFailure>(free.error());
  wend::MotionModel model = settings_.robot;
  model.limits = limits();
  const auto safe = safe_velocity(model, {moment.in_costmap, before}, *want, moment.seconds, *free);
  const bool blocked = !safe || (*safe == wend::Velocity{} && *want != wend::Velocity{});
  told_ = safe.value_or(wend::Velocity{});
  if (follower_) follower_->set_velocity(told_);
  if (!blocked) return told_;
  const bool inside = !free->fits(free->map().frame().to_grid(moment.in_costmap));
  return no_command(ControlFailureKind::no_valid_control,
                    "the robot at " + place_of(moment.in_costmap) +
                        (inside ? " of the costmap's frame is in an obstacle or outside the costmap"
                                : " of the costmap's frame cannot drive on without a collision"));
}

bool PathFollower::is_at_goal(const wend::MapPose& pose) const {
  const double turn = wend::normalized_angle(goal_.heading - pose.heading);
  return distance(pose.point(), goal_.point()) <= goal_distance_ &&
         (goal_heading_ == 0 || std::abs(turn) <= goal_heading_);
}

bool PathFollower::stop() {
  stops_ = true;
  return told_ == wend::Velocity{};
}

void PathFollower::reset() {
  follower_.reset();
  told_ = {};
  begins_ = true;
  stops_ = false;
}

}  // namespace wend_nav2
