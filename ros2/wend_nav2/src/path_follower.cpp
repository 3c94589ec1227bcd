// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/control/given_route.hpp"
#include "wend/geometry/angle.hpp"
#include "wend_nav2/frame_change.hpp"
#include "wend_nav2/pose_faults.hpp"
#include "wend_nav2/safe_velocity.hpp"
#include "wend_nav2/way_ahead.hpp"

namespace wend_nav2 {
namespace {

// Of the goal checker's tolerance: the robot stands well within it.
constexpr double kShareOfTolerance = 0.5;
constexpr double kFastest = 1e4;          // m/s and rad/s: no robot is faster
constexpr double kLongest = 1e3;          // s, for which a command is held
constexpr double kLeastTolerance = 1e-3;  // m, as FollowerOptions has it

bool is_usable(double number) { return std::isfinite(number) && number >= 0; }

wend::Unexpected<ControlFailure> no_command(ControlFailureKind kind, std::string message) {
  return wend::Unexpected<ControlFailure>(ControlFailure{kind, std::move(message)});
}

/// Why there can be no command at such a moment.
std::optional<ControlFailure> why_no_command(const ControlMoment& moment, double most_age) {
  const auto unknown = [](std::string message) {
    return ControlFailure{ControlFailureKind::other, std::move(message)};
  };
  for (const wend::MapPose* pose : {&moment.on_path, &moment.in_costmap}) {
    if (const auto fault = fault_of(*pose)) {
      return unknown("the robot's pose " + place_of(*pose) + " " + *fault);
    }
  }
  if (!(std::abs(moment.velocity.linear) <= kFastest) ||
      !(std::abs(moment.velocity.angular) <= kFastest)) {
    return unknown("the robot's velocity, " + wend::format_number(moment.velocity.linear) +
                   " m/s and " + wend::format_number(moment.velocity.angular) +
                   " rad/s by its odometry, is none");
  }
  if (!(moment.seconds > 0 && moment.seconds <= kLongest)) {
    return unknown("a command cannot be held for " + wend::format_number(moment.seconds) + " s");
  }
  if (most_age > 0 && !(moment.age <= most_age)) {
    return ControlFailure{
        ControlFailureKind::old_pose,
        "the robot's pose is " + wend::format_number(moment.age) + " s old, at most " +
            wend::format_number(most_age) +
            " s expected (pose_timeout): is its odometry or localization silent?"};
  }
  return std::nullopt;
}

/// The route along a path that has no fault. A path of one place leads there from a robot that is nearer than `reach`.
wend::Expected<wend::Route, wend::Error> route_along(const std::vector<wend::MapPose>& path,
                                                     const wend::MapPose& robot, double reach) {
  const wend::MapPose& goal = path.back();
  auto route = wend::given_route(path);
  if (!route || route->length() > 0 || distance(robot.point(), goal.point()) > reach) return route;
  return wend::Route({{wend::MapPolyline({robot.point(), goal.point()})}}, goal.heading);
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
    case ControlFailureKind::old_pose:
      return "old_pose";
    case ControlFailureKind::other:
      break;
  }
  return "other";
}

void PathFollower::set(ControlSettings settings) {
  settings_ = std::move(settings);
  is_set_anew_ = true;
}

void PathFollower::set_goal_tolerance(double distance, double heading) {
  const double goal_distance = is_usable(distance) ? distance : goal_distance_;
  const double goal_heading = is_usable(heading) ? heading : goal_heading_;
  if (goal_distance == goal_distance_ && goal_heading == goal_heading_) return;
  goal_distance_ = goal_distance;
  goal_heading_ = goal_heading;
  is_set_anew_ = true;
}

bool PathFollower::set_speed_limit(double speed) {
  if (!is_usable(speed)) return false;
  speed_limit_ = speed;
  speed_share_ = 1;
  limit_speed();
  return true;
}

bool PathFollower::set_speed_limit_percent(double percent) {
  if (!is_usable(percent)) return false;
  speed_limit_ = 0;
  speed_share_ = percent > 0 ? std::min(percent / 100, 1.0) : 1;
  limit_speed();
  return true;
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

void PathFollower::forget_path() {
  follower_.reset();
  route_.reset();
  path_.clear();
  is_new_ = false;
}

/// Is it driven, or has it been, with the present settings?
bool PathFollower::is_driving(const std::vector<wend::MapPose>& path) const {
  const bool goes_on =
      state_ == wend::FollowerState::driving || state_ == wend::FollowerState::reached;
  return follower_ && goes_on && !is_set_anew_ && path == path_;
}

wend::Expected<void, ControlFailure> PathFollower::set_path(
    const std::vector<wend::MapPose>& path) {
  stops_ = false;
  if (is_driving(path)) return {};
  const bool same_goal = !path.empty() && !path_.empty() && path.back() == path_.back();
  forget_path();
  if (path.empty()) return no_command(ControlFailureKind::invalid_path, "the path has no poses");
  if (auto fault = fault_of(path)) {
    return no_command(ControlFailureKind::invalid_path, *std::move(fault));
  }
  auto controller = wend::make_controller(settings_.controller, settings_.options);
  if (!controller) return no_command(ControlFailureKind::other, controller.error().message);
  controller_ = *std::move(controller);
  if (!same_goal) watch_.restart();
  path_ = path;
  is_new_ = true;
  is_set_anew_ = false;
  return {};
}

/// Begins the new path where the robot is.
wend::Expected<void, ControlFailure> PathFollower::begin(const ControlMoment& moment) {
  auto route = route_along(path_, moment.on_path, settings_.follower.off_path);
  if (!route) {
    forget_path();
    return no_command(ControlFailureKind::invalid_path, route.error().message);
  }
  route_ = *std::move(route);
  wend::FollowerOptions options = settings_.follower;
  options.goal_tolerance = std::max(kShareOfTolerance * goal_distance_, kLeastTolerance);
  options.heading_tolerance = kShareOfTolerance * goal_heading_;
  follower_.emplace(*controller_, limits(), options);
  follower_->follow(*route_);
  is_new_ = false;
  return {};
}

wend::Expected<wend::FreeSpace, ControlFailure> PathFollower::space(const RobotShape& robot) {
  const ObstacleRule rule = rule_for(settings_.plugin.obstacles);
  session_.set_robot(robot_for(rule, robot, settings_.plugin.allow_unknown));
  const auto brought = costmap_.bring_to(session_, scale_for(rule, 0));
  if (!brought) return no_command(ControlFailureKind::other, brought.error().message);
  auto view = session_.view();
  if (!view) return no_command(ControlFailureKind::other, view.error().message);
  return std::move(view->space);
}

/// Has the robot been where it is for too long, whatever paths to this goal it was given?
bool PathFollower::stands_still(const ControlMoment& moment) {
  constexpr double kWay = 0.05;   // m
  constexpr double kTurn = 0.1;   // rad
  constexpr double kShare = 0.1;  // of what the robot can do
  const double stuck_time = settings_.follower.stuck_time;
  const double way = std::min(kWay, kShare * stuck_time * limits().speed);
  const double turn = std::min(kTurn, kShare * stuck_time * limits().turn_rate);
  return watch_.standing_for(moment.on_path, moment.seconds, way, turn) >= stuck_time;
}

wend::Expected<wend::Velocity, ControlFailure> PathFollower::wanted(const ControlMoment& moment) {
  if (stops_) return wend::Velocity{};
  if (path_.empty()) return no_command(ControlFailureKind::invalid_path, "there is no path");
  if (is_new_) {
    if (auto begun = begin(moment); !begun) return wend::Unexpected<ControlFailure>(begun.error());
    follower_->set_velocity(told_);
  }
  const wend::FollowerStep step = follower_->step(moment.on_path, moment.seconds);
  state_ = step.state;
  if (state_ == wend::FollowerState::reached) {
    watch_.restart();
  } else if (stands_still(moment)) {
    state_ = wend::FollowerState::stuck;
  }
  switch (state_) {
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

/// The safe velocity nearest to a wanted one. Where the path leads into an obstacle, it keeps half a cell away from
/// obstacles, which cells show no better than that; in a passage it need not, as the path leads through.
std::optional<wend::Velocity> PathFollower::safe(const ControlMoment& moment,
                                                 const wend::Velocity& before,
                                                 const wend::Velocity& want,
                                                 const wend::FreeSpace& free) const {
  wend::MotionModel model = settings_.robot;
  model.limits = limits();
  const wend::RobotState state{moment.in_costmap, before};
  const auto slowed = [&](const wend::Velocity& wanted, const wend::FreeSpace& space) {
    return safe_velocity(model, state, wanted, moment.seconds, space);
  };
  if (!follower_) return slowed(want, free);
  constexpr double kSeen = 0.5;  // m
  const double braking = before.linear * before.linear / (2 * model.limits.acceleration);
  const double seen = braking + std::abs(before.linear) * moment.seconds +
                      moment.robot.footprint.circumscribed_radius() + kSeen;
  const wend::RouteLeg& leg = route_->legs()[follower_->leg()];
  const FrameChange to_costmap(moment.on_path, moment.in_costmap);
  if (is_free_ahead(leg, follower_->along_leg(), seen, to_costmap, free)) return slowed(want, free);
  wend::Robot grown = free.robot();
  grown.footprint = grown.footprint.grown(free.map().frame().resolution / 2);
  if (const auto wide = wend::make_free_space(free.obstacles(), grown)) {
    if (const auto velocity = slowed(want, *wide)) return velocity;
  }
  return slowed({}, free);
}

wend::Expected<wend::Velocity, ControlFailure> PathFollower::command(const ControlMoment& moment) {
  if (auto fault = why_no_command(moment, settings_.plugin.pose_timeout)) {
    told_ = {};
    return wend::Unexpected<ControlFailure>(*std::move(fault));
  }
  if (std::exchange(begins_, false)) {
    told_ = moment.velocity;
    if (follower_) follower_->set_velocity(told_);
  }
  const wend::Velocity before = told_;
  auto want = wanted(moment);
  told_ = {};
  if (!want) return want;
  const auto free = space(moment.robot);
  if (!free) return wend::Unexpected<ControlFailure>(free.error());
  const auto velocity = safe(moment, before, *want, *free);
  const bool blocked = !velocity || (*velocity == wend::Velocity{} && *want != wend::Velocity{});
  told_ = velocity.value_or(wend::Velocity{});
  if (follower_) follower_->set_velocity(told_);
  if (!blocked) return told_;
  const bool inside = !free->fits(free->map().frame().to_grid(moment.in_costmap));
  return no_command(ControlFailureKind::no_valid_control,
                    "the robot at " + place_of(moment.in_costmap) +
                        (inside ? " of the costmap's frame is in an obstacle or outside the costmap"
                                : " of the costmap's frame cannot drive on without a collision"));
}

bool PathFollower::is_at_goal(const wend::MapPose& pose) const {
  const wend::MapPose& goal = path_.back();
  const double turn = wend::normalized_angle(goal.heading - pose.heading);
  return distance(pose.point(), goal.point()) <= goal_distance_ &&
         (goal_heading_ == 0 || std::abs(turn) <= goal_heading_);
}

bool PathFollower::stop() {
  stops_ = true;
  return told_ == wend::Velocity{};
}

void PathFollower::reset() {
  forget_path();
  watch_.restart();
  told_ = {};
  begins_ = true;
  stops_ = false;
}

}  // namespace wend_nav2
