#include "wend/control/follower.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "wend/control/nearest_ahead.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

bool is_finite(const MapPose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

/// The greatest speed that can be held for a moment and then be braked within `way`.
double braking_speed(double way, double braking, double seconds) {
  return braking * (std::sqrt(seconds * seconds + 2 * way / braking) - seconds);
}

}  // namespace

Follower::Follower(Controller& controller, VelocityLimits limits, FollowerOptions options)
    : controller_(&controller), limits_(limits), options_(options) {}

void Follower::follow(Route route) {
  route_ = std::move(route);
  state_ = route_.valid() ? FollowerState::driving : FollowerState::invalid;
  behind_ = 0;
  arrives_ = false;
  // The first leg last: the controller then has the memory that any leg needs.
  for (std::size_t leg = route_.legs().size(); leg-- > 0;) begin_leg(leg);
}

void Follower::begin_leg(std::size_t leg) {
  leg_ = leg;
  along_ = 0;
  waypoint_ = 0;
  turns_ = current_leg().turn_first && options_.turns_in_place;
  nearest_end_ = std::numeric_limits<double>::infinity();
  idle_ = 0;
  best_headway_ = -std::numeric_limits<double>::infinity();
  least_heading_error_ = std::numeric_limits<double>::infinity();
  controller_->begin(current_leg().line, limits_);
}

void Follower::set_limits(const VelocityLimits& limits) {
  limits_ = limits;
  if (state_ == FollowerState::driving) controller_->begin(current_leg().line, limits_);
}

FollowerStep Follower::step(const MapPose& pose, double seconds) {
  assert(seconds > 0);
  if (state_ != FollowerState::driving) return brake(seconds);
  if (!is_finite(pose)) {
    watch_progress(best_headway_, least_heading_error_, seconds);
    return brake(seconds);
  }
  const MapPose shown = turned_round(pose, current_leg().reverse);
  locate(shown);
  const MapPolyline& line = current_leg().line;
  const double turn_left = normalized_angle(line.at(along_).heading - shown.heading);
  const double heading = line.heading_at(along_, options_.heading_window);
  const double heading_error = normalized_angle(heading - shown.heading);
  if (cross_track_ > options_.off_path) state_ = FollowerState::off_path;
  constexpr double kTurned = 0.05;  // rad
  turns_ = turns_ && std::abs(turn_left) > kTurned;

  if (state_ != FollowerState::driving) {
    brake(seconds);
  } else if (arrives_ || (is_last_leg() && is_at_end_of_leg(pose))) {
    arrive(pose, seconds);
  } else if (is_at_end_of_leg(pose)) {
    behind_ += current_leg().line.length();
    begin_leg(leg_ + 1);
    brake(seconds);
  } else {
    const Velocity wanted = ask_controller(shown, turns_ ? turn_left : 0, seconds);
    velocity_ = limited(wanted, velocity_, limits_, seconds);
    watch_progress(along() - cross_track_, turn_left, seconds);
  }
  return {velocity_, state_, heading_error, cross_track_};
}

FollowerStep Follower::brake(double seconds) {
  velocity_ = limited({}, velocity_, limits_, seconds);
  return {velocity_, state_};
}

/// Where on the leg the robot is, and its next waypoint: neither ever goes back.
void Follower::locate(const MapPose& shown) {
  const MapPolyline& line = current_leg().line;
  const double reach = options_.off_path + limits_.speed;  // of one second
  const OnMapPolyline place =
      nearest_ahead(line, shown, {along_, along_ + reach, options_.acceptance_radius});
  along_ = std::max(along_, place.along);
  cross_track_ = place.distance;
  while (waypoint_ + 1 < line.points().size() &&
         (line.along()[waypoint_] <= along_ ||
          distance(shown.point(), line.points()[waypoint_]) <= options_.acceptance_radius)) {
    ++waypoint_;
  }
}

/// Where it turns in place or changes gear next, and at a goal with a heading, the robot comes nearer than
/// the goal's tolerance, if it does: what it skips, the next leg would begin beside its line.
bool Follower::is_at_end_of_leg(const MapPose& pose) {
  constexpr double kAtEnd = 0.02;  // m
  // Of the tolerance: nearer to the last point, controllers that face it would turn aside.
  constexpr double kAtGoal = 0.4;
  constexpr double kLeaves = 0.005;  // m
  const MapPolyline& line = current_leg().line;
  const double gap = distance(pose.point(), line.points().back());
  const bool leaves = gap > nearest_end_ + kLeaves;
  nearest_end_ = std::min(nearest_end_, gap);
  const double left = line.length() - along_;
  if (left > 2 * options_.goal_tolerance || gap > options_.goal_tolerance) return false;
  if (is_last_leg() && !route_.final_heading()) return true;
  const bool turns_next = !is_last_leg() && route_.legs()[leg_ + 1].turn_first;
  const double at_end = is_last_leg() ? kAtGoal * options_.goal_tolerance : kAtEnd;
  return gap <= at_end || leaves || (!turns_next && left <= at_end);
}

Velocity Follower::ask_controller(const MapPose& shown, double turn, double seconds) {
  const RouteLeg& leg = current_leg();
  const double sign = leg.reverse ? -1 : 1;
  const Velocity as_shown{sign * velocity_.linear, velocity_.angular};
  Velocity wanted = controller_->command(
      {shown, as_shown, &leg.line, along_, waypoint_, seconds, limits_, leg.reverse, turn});
  const double fastest =
      braking_speed(way_left(leg.line, along_, shown.point()), limits_.acceleration, seconds);
  wanted.linear = sign * std::clamp(wanted.linear, -fastest, fastest);
  return wanted;
}

/// Brakes, and turns to the route's last heading if that is asked for.
void Follower::arrive(const MapPose& pose, double seconds) {
  const double error = normalized_angle(route_.end().heading - pose.heading);
  const double tolerance = route_.final_heading() ? options_.heading_tolerance : 0;
  if (!arrives_) {
    arrives_ = true;
    idle_ = 0;
    least_heading_error_ = std::abs(error);
  }
  Velocity wanted;
  if (options_.turns_in_place && tolerance > 0 && std::abs(error) > tolerance / 2) {
    constexpr double kGain = 2;  // 1/s
    const double fastest = braking_speed(std::abs(error), limits_.turn_acceleration, seconds);
    wanted.angular = std::clamp(kGain * error, -fastest, fastest);
  }
  velocity_ = limited(wanted, velocity_, limits_, seconds);
  watch_progress(best_headway_, error, seconds);
  if (velocity_ != Velocity{}) return;
  if (tolerance == 0 || std::abs(error) <= tolerance) {
    state_ = FollowerState::reached;
  } else if (!options_.turns_in_place) {
    state_ = FollowerState::stuck;
  }
}

void Follower::watch_progress(double headway, double heading_error, double seconds) {
  constexpr double kMetres = 0.05;
  constexpr double kRadians = 0.1;
  constexpr double kShare = 0.1;  // of what the robot can do
  const double time = kShare * options_.stuck_time;
  const double turn_left = std::abs(heading_error);
  const bool came_on = headway > best_headway_ + std::min(kMetres, limits_.speed * time);
  const bool turned =
      turn_left < least_heading_error_ - std::min(kRadians, limits_.turn_rate * time);
  if (came_on || turned) {
    best_headway_ = std::max(best_headway_, headway);
    least_heading_error_ = turn_left;
    idle_ = 0;
    return;
  }
  idle_ += seconds;
  if (idle_ >= options_.stuck_time) state_ = FollowerState::stuck;
}

}  // namespace wend
