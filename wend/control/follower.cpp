#include "wend/control/follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "wend/control/nearest_ahead.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

bool is_finite(const MapPose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

bool is_finite(const Velocity& velocity) {
  return std::isfinite(velocity.linear) && std::isfinite(velocity.angular) &&
         std::isfinite(velocity.lateral);
}

bool is_usable(const VelocityLimits& limits, const FollowerOptions& options) {
  const std::array<double, 10> numbers{limits.speed,
                                       limits.turn_rate,
                                       limits.acceleration,
                                       limits.turn_acceleration,
                                       options.acceptance_radius,
                                       options.goal_tolerance,
                                       options.heading_tolerance,
                                       options.off_path,
                                       options.stuck_time,
                                       options.heading_window};
  return std::ranges::all_of(numbers, [](double one) { return std::isfinite(one) && one >= 0; });
}

/// The robot's velocity as the controller of a leg sees it: along the direction of travel.
Velocity velocity_on(const RouteLeg& leg, double course, const Velocity& velocity) {
  const double sign = leg.reverse ? -1 : 1;
  if (course == 0) return {sign * velocity.linear, velocity.angular};
  const auto [sine, cosine] = sine_and_cosine(course);
  return {sign * (cosine * velocity.linear + sine * velocity.lateral), velocity.angular};
}

/// The same back.
Velocity velocity_from(const RouteLeg& leg, double course, const Velocity& wanted) {
  const double linear = (leg.reverse ? -1 : 1) * wanted.linear;
  if (course == 0) return {linear, wanted.angular};
  const auto [sine, cosine] = sine_and_cosine(course);
  return {cosine * linear, wanted.angular, sine * linear};
}

/// The greatest speed that can be held for a moment and then be braked within `way`.
double braking_speed(double way, double braking, double seconds) {
  return braking * (std::sqrt(seconds * seconds + 2 * way / braking) - seconds);
}

}  // namespace

Follower::Follower(Controller& controller, VelocityLimits limits, FollowerOptions options)
    : controller_(&controller), limits_(limits), options_(options) {}

void Follower::follow(Route route, FreeLine can_reach) {
  can_reach_ = std::move(can_reach);
  const bool drives = state_ == FollowerState::driving;
  if (drives && same_route(route, route_)) return;
  const double idle = drives ? idle_ : 0;
  route_ = std::move(route);
  state_ = route_.valid() && is_usable(limits_, options_) ? FollowerState::driving
                                                          : FollowerState::invalid;
  if (state_ == FollowerState::invalid) return;
  behind_ = 0;
  way_to_end_.reset();
  ways_to_end_ = 0;
  cautious_speed_ = std::numeric_limits<double>::infinity();
  joins_ = true;
  // The first leg last: the controller then has the memory that any leg needs.
  for (std::size_t leg = route_.legs().size(); leg-- > 0;) begin_leg(leg);
  idle_ = idle;
}

void Follower::join(const MapPose& pose) {
  joins_ = false;
  const double gap = gap_to_end(pose);
  if (route_.length() == 0 && gap > options_.goal_tolerance && gap <= options_.off_path) {
    drive_to_end(pose, !options_.turns_in_place);
    cautious_speed_ = std::numeric_limits<double>::infinity();
    return;
  }
  const auto place = place_to_join(
      route_, pose,
      {.within = options_.off_path, .tie = options_.acceptance_radius, .can_reach = can_reach_});
  if (!place) return;
  for (std::size_t leg = 0; leg < place->leg; ++leg) behind_ += route_.legs()[leg].line.length();
  const double idle = idle_;
  if (place->leg > 0) begin_leg(place->leg);
  idle_ = idle;
  along_ = place->along;
  turns_ = turns_ && along_ <= options_.acceptance_radius;
}

void Follower::begin_leg(std::size_t leg) {
  leg_ = leg;
  along_ = 0;
  waypoint_ = 0;
  arrives_ = false;
  turns_at_end_ = false;
  turns_ = current_leg().turn_first && options_.turns_in_place;
  nearest_end_ = std::numeric_limits<double>::infinity();
  idle_ = 0;
  best_headway_ = -std::numeric_limits<double>::infinity();
  least_heading_error_ = std::numeric_limits<double>::infinity();
  controller_->begin(current_leg().line, limits_);
}

/// Along a straight line, in reverse if it may and that is nearer to how it stands. It takes two seconds at least,
/// so that commands that come late do not take it beyond the end again.
void Follower::drive_to_end(const MapPose& pose, bool may_reverse) {
  constexpr double kStraight = 0.5;  // rad
  const MapPoint end = route_.end().point();
  const double turn = turn_to(pose, end);
  const bool reverse = may_reverse && std::abs(turn) > kPi / 2;
  const double off = reverse ? kPi - std::abs(turn) : std::abs(turn);
  ++ways_to_end_;
  cautious_speed_ = distance(pose.point(), end) / 2;
  way_to_end_.emplace(RouteLeg{MapPolyline({pose.point(), end}), reverse, off > kStraight, 0});
  begin_leg(leg_);
}

double Follower::gap_to_end(const MapPose& pose) const {
  return distance(pose.point(), route_.end().point());
}

void Follower::set_velocity(const Velocity& velocity) {
  velocity_ = is_finite(velocity) ? velocity : Velocity{};
}

void Follower::set_limits(const VelocityLimits& limits) {
  if (!is_usable(limits, options_)) {
    state_ = FollowerState::invalid;
    return;
  }
  limits_ = limits;
  if (state_ == FollowerState::driving) controller_->begin(current_leg().line, limits_);
}

FollowerStep Follower::step(const MapPose& pose, double seconds) {
  if (!(seconds > 0 && std::isfinite(seconds))) state_ = FollowerState::invalid;
  if (state_ != FollowerState::driving) return brake(seconds);
  if (!is_finite(pose)) {
    watch_progress(best_headway_, least_heading_error_, seconds);
    FollowerStep blind = brake(seconds);
    blind.lost = true;
    return blind;
  }
  if (joins_) join(pose);
  if (!seen_) seen_ = pose;
  const MapPose ahead = turned_round(pose, current_leg().reverse);
  const MapPose shown{ahead.x, ahead.y, ahead.heading + course()};
  locate(shown);
  const double heading = current_leg().line.heading_at(along_, options_.heading_window);
  FollowerStep step{.heading_error = normalized_angle(heading - shown.heading),
                    .cross_track = cross_track_};
  if (cross_track_ > options_.off_path) {
    state_ = FollowerState::off_path;
    brake(seconds);
  } else {
    drive(pose, shown, seconds);
  }
  seen_ = pose;
  step.command = velocity_;
  step.state = state_;
  return step;
}

void Follower::drive(const MapPose& pose, const MapPose& shown, double seconds) {
  const double turn_left = normalized_angle(current_leg().line.at(along_).heading - shown.heading);
  constexpr double kTurned = 0.05;  // rad
  turns_ = turns_ && std::abs(turn_left) > kTurned;
  if (arrives_) {
    arrive(pose, seconds);
  } else if (is_at_end_of_leg(pose)) {
    if (is_last_leg()) {
      begin_to_arrive(pose);
      arrive(pose, seconds);
    } else {
      behind_ += current_leg().line.length();
      begin_leg(leg_ + 1);
      brake(seconds);
    }
  } else {
    const Velocity wanted = ask_controller(shown, turns_ ? turn_left : 0, seconds);
    if (!is_finite(wanted)) {
      state_ = FollowerState::invalid;
      brake(seconds);
      return;
    }
    velocity_ = limited(wanted, velocity_, limits_, seconds);
    watch_progress(along() - cross_track_, turn_left, seconds);
  }
}

FollowerStep Follower::brake(double seconds) {
  const bool known = seconds > 0 && std::isfinite(seconds) && is_usable(limits_, options_);
  velocity_ = known ? limited({}, velocity_, limits_, seconds) : Velocity{};
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

/// Where it turns in place or changes gear next, and at the goal, the robot comes nearer than the goal's
/// tolerance, if it does: what it skips, the next leg would begin beside its line. Where it passes the end at speed,
/// it may be beyond the tolerance by now.
bool Follower::is_at_end_of_leg(const MapPose& pose) {
  // A robot that steers cannot turn afterwards by what an arc turns on the last centimetres.
  const double at_leg = options_.turns_in_place ? 0.02 : 0.005;  // m
  // Of the tolerance: nearer to the last point, controllers that face it would turn aside. A robot that steers turns
  // up to the last point.
  const double at_heading = options_.turns_in_place ? 0.4 : 0.1;
  constexpr double kAtPoint = 0.7;   // the same without a heading
  constexpr double kLeaves = 0.005;  // m
  constexpr double kBeside =
      3;  // of the tolerance: so far beside the end of the route it stops, too
  const MapPolyline& line = current_leg().line;
  const double gap = distance(pose.point(), line.points().back());
  const double left = line.length() - along_;
  const bool leaves = gap > nearest_end_ + kLeaves && left <= along_;
  nearest_end_ = std::min(nearest_end_, gap);
  const double tolerance = options_.goal_tolerance;
  const double beside = is_last_leg() ? kBeside * tolerance : tolerance;
  if (leaves && left <= at_leg && nearest_end_ <= beside) return true;
  if (left > 2 * tolerance || gap > tolerance) return false;
  const bool turns_next = !is_last_leg() && route_.legs()[leg_ + 1].turn_first;
  const double at_goal = (route_.final_heading() ? at_heading : kAtPoint) * tolerance;
  const double at_end = is_last_leg() ? at_goal : at_leg;
  return gap <= at_end || leaves || (!turns_next && left <= at_end);
}

Velocity Follower::ask_controller(const MapPose& shown, double turn, double seconds) {
  const RouteLeg& leg = current_leg();
  Velocity wanted = controller_->command({shown, velocity_on(leg, course(), velocity_), &leg.line,
                                          along_, waypoint_, seconds, limits_, leg.reverse, turn});
  const double way = way_left(leg.line, along_, shown.point());
  const double fastest =
      std::min(braking_speed(way, limits_.acceleration, seconds), cautious_speed_);
  wanted.linear = std::clamp(wanted.linear, -fastest, fastest);
  return velocity_from(leg, course(), wanted);
}

void Follower::begin_to_arrive(const MapPose& pose) {
  arrives_ = true;
  turns_at_end_ = false;
  waited_ = 0;
  seen_then_ = pose;
  idle_ = 0;
  least_heading_error_ = std::abs(normalized_angle(route_.end().heading - pose.heading));
}

/// Was it told to stand, and hardly moved since the last step? Poses with noise never stand still: of these a
/// while decides.
bool Follower::stands(const MapPose& pose, double seconds) {
  constexpr double kSpeed = 0.01;     // m/s
  constexpr double kTurnRate = 0.02;  // rad/s
  constexpr double kWhile = 1;        // s
  if (velocity_ != Velocity{}) {
    waited_ = 0;
    seen_then_ = pose;
    return false;
  }
  const MapPose seen = seen_.value_or(pose);
  const double turned = std::abs(normalized_angle(pose.heading - seen.heading));
  if (distance(pose.point(), seen.point()) <= kSpeed * seconds && turned <= kTurnRate * seconds) {
    return true;
  }
  waited_ += seconds;
  if (waited_ < kWhile) return false;
  waited_ = 0;
  return distance(pose.point(), std::exchange(seen_then_, pose).point()) <= options_.goal_tolerance;
}

/// Brakes until the robot stands; drives to the route's end if it stands beside it; then turns to the last
/// heading, if the route has one. A robot that leaves the end while it turns would do so again.
void Follower::arrive(const MapPose& pose, double seconds) {
  constexpr int kMostWays = 8;
  const double error = normalized_angle(route_.end().heading - pose.heading);
  const double tolerance = route_.final_heading() ? options_.heading_tolerance : 0;
  const bool beside = gap_to_end(pose) > options_.goal_tolerance;
  const bool still = stands(pose, seconds);
  if (still && beside && !turns_at_end_ && ways_to_end_ < kMostWays) {
    drive_to_end(pose, true);
    brake(seconds);
    return;
  }
  const bool turned_away = tolerance > 0 && std::abs(error) > tolerance / 2;
  turns_at_end_ = turns_at_end_ || (still && options_.turns_in_place && turned_away);
  Velocity wanted;
  if (turns_at_end_ && turned_away) {
    constexpr double kGain = 2;  // 1/s
    const double fastest = braking_speed(std::abs(error), limits_.turn_acceleration, seconds);
    wanted.angular = std::clamp(kGain * error, -fastest, fastest);
  }
  velocity_ = limited(wanted, velocity_, limits_, seconds);
  watch_progress(best_headway_, error, seconds);
  if (!still || velocity_ != Velocity{}) return;
  const bool faces = tolerance == 0 || std::abs(error) <= tolerance;
  state_ = faces && !beside ? FollowerState::reached : FollowerState::stuck;
}

void Follower::watch_progress(double headway, double heading_error, double seconds) {
  constexpr double kMetres = 0.05;
  constexpr double kRadians = 0.1;
  constexpr double kShare = 0.1;  // of what the robot can do
  const double time = kShare * options_.stuck_time;
  const double turn_left = std::abs(heading_error);
  const bool first = std::isinf(least_heading_error_) && !std::isinf(turn_left);
  const bool came_on = headway > best_headway_ + std::min(kMetres, limits_.speed * time);
  const bool turned =
      turn_left < least_heading_error_ - std::min(kRadians, limits_.turn_rate * time);
  if (came_on || turned) {
    best_headway_ = std::max(best_headway_, headway);
    least_heading_error_ = turn_left;
    if (!first) idle_ = 0;
    return;
  }
  idle_ += seconds;
  if (idle_ >= options_.stuck_time) state_ = FollowerState::stuck;
}

}  // namespace wend
