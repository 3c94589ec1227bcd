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
        "the robot's pose is " + wend::format_number(std::round(moment.age * 100) / 100) +
            " s old, at most " + wend::format_number(most_age) +
            " s expected (pose_timeout): is its odometry or localization silent?"};
  }
  return std::nullopt;
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
}

wend::Expected<void, ControlFailure> PathFollower::make_follower() {
  auto controller = wend::make_controller(settings_.controller, settings_.options);
  if (!controller) return no_command(ControlFailureKind::other, controller.error().message);
  controller_ = *std::move(controller);
  wend::FollowerOptions options = settings_.follower;
  options.goal_tolerance = std::max(kShareOfTolerance * goal_distance_, kLeastTolerance);
  options.heading_tolerance = kShareOfTolerance * goal_heading_;
  follower_.emplace(*controller_, limits(), options);
  follower_->set_velocity(told_);
  is_set_anew_ = false;
  return {};
}

wend::Expected<void, ControlFailure> PathFollower::set_path(
    const std::vector<wend::MapPose>& path) {
  stops_ = false;
  const auto refused = [this](std::string why) {
    forget_path();
    return no_command(ControlFailureKind::invalid_path, std::move(why));
  };
  if (path.empty()) return refused("the path has no poses");
  if (auto fault = fault_of(path)) return refused(*std::move(fault));
  auto route = wend::given_route(path);
  if (!route) return refused(route.error().message);
  if (!follower_ || is_set_anew_) {
    forget_path();
    if (auto made = make_follower(); !made) return made;
  }
  route_ = *std::move(route);
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): it was made by now
  follower_->follow(*route_, [this](const wend::MapPose& from, wend::MapPoint to) {
    return can_reach(from, to);
  });
  return {};
}

/// Is no wall between? Of the costmap at the moment of a command.
bool PathFollower::can_reach(const wend::MapPose& from, wend::MapPoint to) const {
  const wend::RouteLeg line{wend::MapPolyline({from.point(), to})};
  return !free_ || !to_costmap_ || is_free_ahead(line, 0, line.line.length(), *to_costmap_, *free_);
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

wend::Expected<wend::Velocity, ControlFailure> PathFollower::wanted(const ControlMoment& moment) {
  if (stops_ || !follower_) return wend::Velocity{};
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
  if (!follower_ || !route_ || !to_costmap_) return slowed(want, free);
  constexpr double kSeen = 0.5;  // m
  const double braking = before.linear * before.linear / (2 * model.limits.acceleration);
  const double seen = braking + std::abs(before.linear) * moment.seconds +
                      moment.robot.footprint.circumscribed_radius() + kSeen;
  const wend::RouteLeg& leg = route_->legs()[follower_->leg()];
  if (is_free_ahead(leg, follower_->along_leg(), seen, *to_costmap_, free)) {
    return slowed(want, free);
  }
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
  const wend::Velocity before = std::exchange(told_, {});
  if (!route_ && !stops_) return no_command(ControlFailureKind::invalid_path, "there is no path");
  const auto free = space(moment.robot);
  if (!free) return wend::Unexpected<ControlFailure>(free.error());
  free_ = *free;
  to_costmap_.emplace(moment.on_path, moment.in_costmap);
  auto want = wanted(moment);
  free_.reset();  // an edit of it is cheaper if there is no copy
  if (!want) return want;
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
  if (!route_) return false;
  const wend::MapPose& goal = route_->end();
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
  told_ = {};
  begins_ = true;
  stops_ = false;
}

}  // namespace wend_nav2
