#include "wend/path/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "wend/base/options.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/small_jump.hpp"
#include "wend/path/speed_passes.hpp"

namespace wend {
namespace {

constexpr double kStraight = 1e-9;  // radians: a turn of no more is rounding, as of a Corner

std::optional<Error> fault_of(const TrajectoryLimits& limits) {
  std::optional<Error> fault;
  TrajectoryLimits::fields(limits, [&](const OptionText& text, double value, OptionRange) {
    if (fault || (std::isfinite(value) && value > 0)) return;
    const std::string name(text.name);
    fault = Error{Status::invalid_option, name + " must be finite and greater than 0", name};
  });
  return fault;
}

bool turns_in_place(const MapSegment& segment) { return segment.length == 0; }

bool goes_nowhere(const MapSegment& segment) {
  return segment.length == 0 && std::abs(segment.turn) <= kStraight;
}

/// What its speeds are along: metres, or radians of a turn in place.
double extent_of(const MapSegment& segment) {
  return std::abs(turns_in_place(segment) ? segment.turn : segment.length);
}

double curvature_of(const MapSegment& segment) { return segment.turn / segment.length; }

double fastest_along(const MapSegment& segment, const TrajectoryLimits& limits) {
  return turns_in_place(segment) ? limits.turn_rate : fastest_on(curvature_of(segment), limits);
}

double acceleration_along(const MapSegment& segment, const TrajectoryLimits& limits) {
  return turns_in_place(segment) ? limits.turn_acceleration : limits.acceleration;
}

/// The direction in which the base point starts to move.
double direction_of(const MapSegment& segment) {
  return segment.from.heading + segment.course + (segment.length < 0 ? kPi : 0);
}

/// May the robot go on from one to the next without a stop?
bool goes_on(const MapSegment& before, const MapSegment& after) {
  if (turns_in_place(before) || turns_in_place(after)) {
    return before.length == after.length && before.turn * after.turn > 0;
  }
  const double jump = direction_of(after) - direction_of(before) - before.turn;
  return std::abs(normalized_angle(jump)) <= kSmallJump;
}

/// The segments of a path in metres, without those that go nowhere.
std::vector<MapSegment> segments_in_metres(const Path& path, const Frame& frame,
                                           DeadlineCheck& stop) {
  std::vector<MapSegment> segments;
  for (const Segment& segment : path.segments()) {
    if (stop()) break;
    segments.emplace_back(frame.to_metres(segment.from), segment.length * frame.resolution,
                          segment.turn, segment.course);
  }
  std::erase_if(segments, goes_nowhere);
  return segments;
}

/// With turns in place where lines meet.
std::vector<MapSegment> with_corners(std::span<const MapSegment> lines) {
  std::vector<MapSegment> segments;
  for (const MapSegment& line : lines) {
    if (!segments.empty()) {
      const double heading = segments.back().from.heading;
      const double turn = normalized_angle(line.from.heading - heading);
      const MapPose corner{line.from.x, line.from.y, heading};
      if (std::abs(turn) > kStraight) segments.emplace_back(corner, 0.0, turn, 0.0);
    }
    segments.push_back(line);
  }
  return segments;
}

/// What a robot drives along a path, in metres.
std::vector<MapSegment> driven_segments(const Path& path, const Frame& frame, DeadlineCheck& stop) {
  std::vector<MapSegment> segments = segments_in_metres(path, frame, stop);
  return path.visit([&](const JoinedPoses&) { return std::move(segments); },
                    [&](const auto&) { return with_corners(segments); });
}

/// The squares of the speeds at the joints of the segments, the start and the end included.
std::vector<double> squared_speeds(std::span<const MapSegment> segments,
                                   const TrajectoryLimits& limits) {
  std::vector<double> squared(segments.size() + 1, 0);
  for (std::size_t i = 1; i < segments.size(); ++i) {
    if (!goes_on(segments[i - 1], segments[i])) continue;
    const double fastest =
        std::min(fastest_along(segments[i - 1], limits), fastest_along(segments[i], limits));
    squared[i] = fastest * fastest;
  }
  const auto change = [&](std::size_t i) {
    return 2 * acceleration_along(segments[i], limits) * extent_of(segments[i]);
  };
  limit_acceleration(squared, change);
  limit_braking(squared, change);
  return squared;
}

}  // namespace

double fastest_on(double curvature, const TrajectoryLimits& limits) {
  const double bend = std::abs(curvature);
  return std::min(
      {limits.speed, limits.turn_rate / bend, std::sqrt(limits.lateral_acceleration / bend)});
}

Expected<Trajectory, Error> Trajectory::along(const Path& path, const Frame& frame,
                                              const TrajectoryLimits& limits,
                                              const Deadline& deadline) {
  if (auto fault = fault_of(limits)) return Unexpected<Error>(*std::move(fault));
  if (auto fault = wend::fault_of(path)) return Unexpected<Error>(*std::move(fault));
  DeadlineCheck stop(&deadline);
  Trajectory trajectory;
  trajectory.limits_ = limits;
  trajectory.segments_ = driven_segments(path, frame, stop);
  const std::vector<MapSegment>& segments = trajectory.segments_;
  trajectory.start_ = frame.to_metres(path.poses().front());
  trajectory.end_ = segments.empty() ? trajectory.start_ : end_of(segments.back());
  const std::vector<double> squared = squared_speeds(segments, limits);
  for (std::size_t i = 0; i < segments.size() && !stop(); ++i) {
    trajectory.drive(i, squared[i], squared[i + 1]);
  }
  if (stop.now())
    return failure(deadline.status(), deadline.text() + ", before the path was timed");
  const MapPose& end = trajectory.end_;
  if (!std::isfinite(trajectory.duration_ + end.x + end.y + end.heading)) {
    return failure(
        Status::unsupported_query,
        "the path is too long to be timed, or the frame has numbers that are not finite");
  }
  return trajectory;
}

Expected<Trajectory, Error> Trajectory::through(std::span<const TimedPose> poses) {
  if (poses.empty()) return failure(Status::unsupported_query, "the trajectory has no poses");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto& [time, pose] = poses[i];
    const std::string name = "pose " + std::to_string(i) + " of the trajectory";
    if (!std::isfinite(time + pose.x + pose.y + pose.heading)) {
      return failure(Status::unsupported_query, name + " contains NaN or infinity");
    }
    if (i > 0 && !(time > poses[i - 1].time)) {
      return failure(Status::unsupported_query, name + " is not later than the pose before it");
    }
  }
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Trajectory trajectory;
  trajectory.limits_ = {0, 0, kNone, kNone, kNone};
  trajectory.start_ = poses.front().pose;
  trajectory.end_ = poses.back().pose;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const MapPose& from = poses[i - 1].pose;
    const MapPose& to = poses[i].pose;
    // Between equal frames, metres and cells are one.
    const Segment segment =
        segment_between({from.x, from.y, from.heading}, {to.x, to.y, to.heading});
    trajectory.drive_for(poses[i].time - poses[i - 1].time,
                         {from, segment.length, segment.turn, segment.course});
  }
  if (!std::isfinite(trajectory.limits_.speed + trajectory.limits_.turn_rate)) {
    return failure(Status::unsupported_query,
                   "the poses of the trajectory are too far apart for their times");
  }
  return trajectory;
}

/// Drives a segment at a constant speed.
void Trajectory::drive_for(double seconds, const MapSegment& segment) {
  limits_.speed = std::max(limits_.speed, std::abs(segment.length) / seconds);
  limits_.turn_rate = std::max(limits_.turn_rate, std::abs(segment.turn) / seconds);
  pieces_.push_back({segments_.size(), duration_, seconds, 0, extent_of(segment) / seconds, 0});
  segments_.push_back(segment);
  duration_ += seconds;
}

/// Drives a segment from the joint before to the joint after it: accelerates, holds, brakes.
void Trajectory::drive(std::size_t segment, double squared_before, double squared_after) {
  const double extent = extent_of(segments_[segment]);
  const double fastest = fastest_along(segments_[segment], limits_);
  const double acceleration = acceleration_along(segments_[segment], limits_);
  // Where accelerating and braking would meet.
  const double met = (squared_before + squared_after) / 2 + acceleration * extent;
  const double peak = std::max({std::min(fastest * fastest, met), squared_before, squared_after});
  const double up = (peak - squared_before) / (2 * acceleration);
  const double down = (peak - squared_after) / (2 * acceleration);
  double along = 0;
  const auto add = [&](double length, double from, double to, double change) {
    constexpr double kRounding = 1e-12;  // of the segment
    if (length <= kRounding * extent) return;
    const double duration = 2 * length / (std::sqrt(from) + std::sqrt(to));
    pieces_.push_back({segment, duration_, duration, along, std::sqrt(from), change});
    along += length;
    duration_ += duration;
  };
  add(up, squared_before, peak, acceleration);
  add(extent - up - down, peak, peak, 0);
  add(down, peak, squared_after, -acceleration);
}

double Trajectory::length() const {
  double length = 0;
  for (const MapSegment& segment : segments_) length += std::abs(segment.length);
  return length;
}

double Trajectory::smallest_turning_radius() const {
  double radius = std::numeric_limits<double>::infinity();
  for (const MapSegment& segment : segments_) {
    radius = std::min(radius, std::abs(segment.length / segment.turn));
  }
  return radius;
}

TrajectoryState Trajectory::at(double time) const {
  if (pieces_.empty() || !(time > 0)) return {time > 0 ? time : 0, start_, 0, 0};
  if (time >= duration_) return {time, end_, 0, 0};
  const auto next = std::ranges::upper_bound(pieces_, time, {}, &TrajectoryPiece::time);
  const TrajectoryPiece& piece = *std::prev(next);
  TrajectoryState state = state_on(piece, std::min(time - piece.time, piece.duration));
  state.time = time;
  return state;
}

TrajectoryState Trajectory::state_on(const TrajectoryPiece& piece, double seconds) const {
  const MapSegment& segment = segments_[piece.segment];
  const double along = piece.along + (piece.speed + piece.acceleration * seconds / 2) * seconds;
  const double speed = std::max(piece.speed + piece.acceleration * seconds, 0.0);
  const double extent = extent_of(segment);
  const double share = extent > 0 ? std::clamp(along / extent, 0.0, 1.0) : 0;
  const double signed_speed = std::copysign(speed, segment.length);
  return turns_in_place(segment)
             ? TrajectoryState{0, pose_on(segment, share), 0, std::copysign(speed, segment.turn)}
             : TrajectoryState{0, pose_on(segment, share), signed_speed,
                               signed_speed * curvature_of(segment)};
}

std::vector<TrajectoryState> Trajectory::samples(double period) const {
  constexpr double kRounding = 1e-6;  // of a period: no sample that near to the end
  const double count = std::ceil(duration_ / period - kRounding);
  if (!(period > 0 && count < static_cast<double>(kMostSamples))) return {};
  const auto periods = static_cast<std::size_t>(count);
  std::vector<TrajectoryState> states;
  states.reserve(periods + 1);
  const double rate = 1 / period;  // dividing by 20 gives 0.15, where multiplying by 0.05 does not
  for (std::size_t i = 0; i < periods; ++i) states.push_back(at(static_cast<double>(i) / rate));
  states.push_back(at(duration_));
  return states;
}

}  // namespace wend
