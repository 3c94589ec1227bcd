#include "wend/control/route.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/path/small_jump.hpp"

namespace wend {
namespace {

constexpr double kNoTurn = 1e-6;  // rad: a smaller one is rounding

bool can_hold(const Path& path, const Frame& frame) {
  const auto holds = [&](Point point) { return Route::can_hold(frame.to_metres(point)); };
  const auto faces = [](const Pose& pose) { return Route::can_hold(pose.heading); };
  return std::ranges::all_of(path.points(), holds) &&
         std::ranges::all_of(path.driven_poses(), faces);
}

bool can_hold(const RouteLeg& leg) {
  return std::isfinite(leg.course) && std::ranges::all_of(leg.line.points(), [](MapPoint point) {
           return Route::can_hold(point);
         });
}

/// Without points that lie on top of the one before. The last point stays.
MapPolyline without_tiny_pieces(std::span<const MapPoint> points, bool closed) {
  std::vector<MapPoint> kept;
  kept.reserve(points.size());
  for (const MapPoint point : points) {
    if (kept.empty() || distance(kept.back(), point) > Route::kSamePlace) kept.push_back(point);
  }
  kept.back() = points.back();
  while (kept.size() > 1 && distance(kept[kept.size() - 2], kept.back()) <= Route::kSamePlace) {
    kept.erase(kept.end() - 2);
  }
  while (closed && kept.size() > 1 && distance(kept.front(), kept.back()) <= Route::kSamePlace) {
    kept.pop_back();
  }
  return MapPolyline(kept, closed);
}

MapPolyline without_tiny_pieces(const MapPolyline& line) {
  const auto points = line.points();
  const bool repeats = line.closed() && points.size() > 1;
  return without_tiny_pieces(points.first(points.size() - (repeats ? 1 : 0)), line.closed());
}

MapPolyline in_metres(std::span<const Point> points, const Frame& frame, bool closed) {
  std::vector<MapPoint> metres;
  metres.reserve(points.size());
  for (const Point point : points) metres.push_back(frame.to_metres(point));
  return without_tiny_pieces(metres, closed);
}

/// Poses on top of each other are at one point exactly, and one pose if they face the same way.
std::vector<Pose> without_tiny_moves(std::span<const Pose> poses, const Frame& frame) {
  std::vector<Pose> kept;
  kept.reserve(poses.size());
  for (Pose pose : poses) {
    if (!kept.empty()) {
      const Pose& last = kept.back();
      if (distance(last.point(), pose.point()) * frame.resolution <= Route::kSamePlace) {
        if (std::abs(normalized_angle(pose.heading - last.heading)) <= kNoTurn) continue;
        pose = {last.x, last.y, pose.heading};
      }
    }
    kept.push_back(pose);
  }
  return kept;
}

double direction_of(const Segment& segment) {
  return segment.from.heading + segment.course + (segment.length < 0 ? kPi : 0);
}

/// Does the direction of travel jump by so much that the robot has to stop? In reverse it is that of its back.
bool jumps_between(const Segment& before, const Segment& after) {
  const double gear = before.length * after.length < 0 ? kPi : 0;
  const double jump = direction_of(after) + gear - direction_of(before) - before.turn;
  return std::abs(normalized_angle(jump)) > kSmallJump;
}

bool is_aside(const Segment& segment) { return std::abs(segment.course) > kSmallJump; }

double chords_of(const JoinedPoses& joined, double tolerance) {
  double count = 0;
  for (std::size_t i = 0; i < joined.segment_count(); ++i) {
    count += chord_count(way_of_base(joined.segment(i)), tolerance);
  }
  return count;
}

/// In cells: a hundredth of one, or a millimetre, where that is less: chords of large cells would lead aside. More
/// where the arcs would need more than kMostChords, as those of poses thousands of kilometres apart.
double chord_tolerance(const JoinedPoses& joined, const Frame& frame) {
  constexpr double kCells = 0.01;
  constexpr double kMetres = 0.001;
  double tolerance = std::min(kCells, kMetres / frame.resolution);
  constexpr double kLeast = 4;  // of an arc, at any tolerance
  const double most = Route::kMostChords + kLeast * static_cast<double>(joined.segment_count());
  double count = chords_of(joined, tolerance);
  while (count > most) {
    tolerance *= 2 * (count / most) * (count / most);
    count = chords_of(joined, tolerance);
  }
  return tolerance;
}

/// Does a leg end between two segments that no turn in place separates?
bool ends_between(const Segment& before, const Segment& after) {
  const double changes = normalized_angle(after.course - before.course);
  return before.length * after.length < 0 || jumps_between(before, after) ||
         ((is_aside(before) || is_aside(after)) && std::abs(changes) > kSmallJump);
}

/// One leg for each stretch of segments in one direction, without turns in place but at its ends.
std::vector<RouteLeg> legs_along(const JoinedPoses& joined, const Frame& frame) {
  std::vector<RouteLeg> legs;
  std::vector<Arc> arcs;          // of this leg
  std::optional<Segment> before;  // of this leg, the last
  double course = 0;              // of this leg
  const double tolerance = chord_tolerance(joined, frame);
  bool turn_first = false;
  bool turns = false;  // before the next segment
  const auto end_leg = [&] {
    if (arcs.empty()) return;
    const Polyline line = polyline_of(arcs, tolerance);
    legs.push_back(
        {in_metres(line.points(), frame, false), before->length < 0, turn_first, course});
    arcs.clear();
  };
  for (std::size_t i = 0; i < joined.segment_count(); ++i) {
    const Segment segment = joined.segment(i);
    if (segment.length == 0) {
      turns = true;
      continue;
    }
    if (turns || (before && ends_between(*before, segment))) {
      end_leg();
      turn_first = turns || (before && jumps_between(*before, segment));
    }
    if (arcs.empty()) course = is_aside(segment) ? segment.course : 0;
    arcs.push_back(way_of_base(segment));
    before = segment;
    turns = false;
  }
  end_leg();
  return legs;
}

/// By a straight line that is driven ahead, so it is no part of a leg in reverse.
void join_end_to_start(std::vector<RouteLeg>& legs) {
  const MapPoint first = legs.front().line.points().front();
  const auto last_points = legs.back().line.points();
  std::vector<MapPoint> points(last_points.begin(), last_points.end());
  if (points.back() == first) return;
  if (legs.back().reverse) {
    legs.push_back({MapPolyline({points.back(), first}), false});
  } else {
    points.push_back(first);
    legs.back().line = MapPolyline(points);
  }
}

/// How the robot stands there.
MapPose facing(const RouteLeg& leg, double along) { return seen_on(leg, leg.line.at(along)); }

}  // namespace

MapPose turned_round(const MapPose& pose, bool reverse) {
  return reverse ? MapPose{pose.x, pose.y, normalized_angle(pose.heading + kPi)} : pose;
}

MapPose shown_on(const RouteLeg& leg, const MapPose& pose) {
  const MapPose shown = turned_round(pose, leg.reverse);
  if (leg.course == 0) return shown;
  return {shown.x, shown.y, normalized_angle(shown.heading + leg.course)};
}

MapPose seen_on(const RouteLeg& leg, const MapPose& shown) {
  if (leg.course == 0) return turned_round(shown, leg.reverse);
  return turned_round({shown.x, shown.y, normalized_angle(shown.heading - leg.course)},
                      leg.reverse);
}

std::optional<Pose> first_step_aside(const Path& path) {
  for (const Segment& segment : path.segments()) {
    if (segment.length != 0 && std::abs(segment.course) > kSmallJump) return segment.from;
  }
  return std::nullopt;
}

std::optional<Pose> first_turn_in_place(const Path& path) {
  std::optional<Segment> before;
  for (std::size_t i = 0; i + 1 < path.driven_poses().size(); ++i) {
    const Segment segment = JoinedPoses(path.driven_poses()).segment(i);
    const bool turns = segment.length == 0 && std::abs(segment.turn) > kNoTurn;
    if (turns || (before && segment.length != 0 && jumps_between(*before, segment))) {
      return segment.from;
    }
    if (segment.length != 0) before = segment;
  }
  return std::nullopt;
}

std::optional<Pose> first_bend_tighter_than(double radius, const Path& path) {
  constexpr double kEvened = 0.02;  // rad
  for (std::size_t i = 0; i + 1 < path.driven_poses().size(); ++i) {
    const Segment segment = JoinedPoses(path.driven_poses()).segment(i);
    if (std::abs(segment.turn) > std::abs(segment.length) / radius + kEvened) return segment.from;
  }
  return std::nullopt;
}

bool Route::can_hold(double heading) {
  return std::abs(heading) <= kLargestHeading;  // so not NaN
}

bool Route::can_hold(MapPoint point) {
  return std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest;  // so not NaN
}

Route::Route(const Path& path, const Frame& frame, bool closed) {
  assert(!path.empty());
  if (!wend::can_hold(path, frame)) {
    invalidate();
    return;
  }
  const auto follow_lines = [&](const auto&) {
    legs_.push_back({in_metres(path.points(), frame, closed), false});
    set_ends(facing(legs_.front(), 0));
  };
  path.visit(follow_lines, [&](const JoinedPoses& joined) { follow(joined, frame, closed); });
}

void Route::follow(const JoinedPoses& joined, const Frame& frame, bool closed) {
  const std::vector<Pose> poses = without_tiny_moves(joined.poses(), frame);
  legs_ = legs_along(JoinedPoses(poses), frame);
  if (legs_.empty()) legs_.push_back({MapPolyline({frame.to_metres(poses.back().point())})});
  if (closed) join_end_to_start(legs_);
  if (!closed) final_heading_ = frame.to_metres(joined.poses().back()).heading;
  set_ends(frame.to_metres(joined.poses().front()));
}

Route::Route(std::vector<RouteLeg> legs, std::optional<double> final_heading)
    : legs_(std::move(legs)), final_heading_(final_heading) {
  assert(!legs_.empty());
  const bool heads = !final_heading || can_hold(*final_heading);
  if (!heads || !std::ranges::all_of(legs_, [](const auto& leg) { return wend::can_hold(leg); })) {
    invalidate();
    return;
  }
  for (RouteLeg& leg : legs_) leg.line = without_tiny_pieces(leg.line);
  set_ends(facing(legs_.front(), 0));
}

void Route::set_ends(const MapPose& start) {
  start_ = start;
  end_ = facing(legs_.back(), legs_.back().line.length());
  if (final_heading_) end_.heading = *final_heading_;
}

void Route::invalidate() {
  valid_ = false;
  final_heading_.reset();
  legs_.assign(1, RouteLeg{MapPolyline({MapPoint{}})});
  set_ends(MapPose{});
}

double Route::length() const {
  double length = 0;
  for (const RouteLeg& leg : legs_) length += leg.line.length();
  return length;
}

}  // namespace wend
