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

MapPolyline in_metres(const Polyline& line, const Frame& frame, bool closed) {
  std::vector<MapPoint> points;
  points.reserve(line.points().size());
  for (const Point point : line.points()) points.push_back(frame.to_metres(point));
  return MapPolyline(points, closed);
}

/// Does the robot turn in place between two arcs of one direction?
bool turns_between(const Arc& before, const Arc& after) {
  const double jump = normalized_angle(after.from.heading - before.from.heading - before.turn());
  return std::abs(jump) > kSmallJump;
}

/// Does the robot turn in place before the first arc that has a length?
bool turns_at_start(std::span<const Arc> arcs) {
  const auto moving = std::ranges::find_if(arcs, [](const Arc& arc) { return arc.length != 0; });
  if (moving == arcs.end()) return false;
  return std::abs(normalized_angle(moving->from.heading - arcs.front().from.heading)) > kSmallJump;
}

/// One leg for each stretch of arcs (at least one) in one direction, without turns in place but at its
/// ends.
std::vector<RouteLeg> legs_along(std::span<const Arc> arcs, const Frame& frame) {
  std::vector<RouteLeg> legs;
  bool turn_first = turns_at_start(arcs);
  for (std::size_t first = 0; first < arcs.size();) {
    std::size_t end = first;
    const Arc* last = nullptr;  // the leg's last arc that has a length
    bool turns = false;
    for (; end < arcs.size(); ++end) {
      if (arcs[end].length == 0) continue;
      turns = last != nullptr && turns_between(*last, arcs[end]);
      if (turns || (last != nullptr && last->length * arcs[end].length < 0)) break;
      last = &arcs[end];
    }
    const Polyline line = polyline_of(arcs.subspan(first, end - first));
    legs.push_back(
        {in_metres(line, frame, false), last != nullptr && last->length < 0, turn_first});
    turn_first = turns;
    first = end;
  }
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
MapPose facing(const RouteLeg& leg, double along) {
  return turned_round(leg.line.at(along), leg.reverse);
}

}  // namespace

MapPose turned_round(const MapPose& pose, bool reverse) {
  return reverse ? MapPose{pose.x, pose.y, normalized_angle(pose.heading + kPi)} : pose;
}

std::optional<Pose> first_step_aside(const Path& path) {
  for (const Segment& segment : path.segments()) {
    if (segment.length != 0 && std::abs(segment.course) > kSmallJump) return segment.from;
  }
  return std::nullopt;
}

Route::Route(const Path& path, const Frame& frame, bool closed) {
  assert(!path.empty());
  const auto follow_lines = [&](const auto&) {
    legs_.push_back({in_metres(polyline_of(path), frame, closed), false});
    start_ = facing(legs_.front(), 0);
  };
  path.visit(follow_lines, [&](const JoinedPoses& joined) {
    const bool moves = joined.segment_count() > 0;
    legs_ = moves ? legs_along(path.arcs(), frame)
                  : std::vector{RouteLeg{in_metres(polyline_of(path), frame, false)}};
    if (closed) join_end_to_start(legs_);
    start_ = frame.to_metres(joined.poses().front());
    if (!closed) final_heading_ = frame.to_metres(joined.poses().back()).heading;
  });
  end_ = facing(legs_.back(), legs_.back().line.length());
  if (final_heading_) end_.heading = *final_heading_;
}

Route::Route(std::vector<RouteLeg> legs, std::optional<double> final_heading)
    : legs_(std::move(legs)), final_heading_(final_heading) {
  assert(!legs_.empty());
  start_ = facing(legs_.front(), 0);
  end_ = facing(legs_.back(), legs_.back().line.length());
  if (final_heading_) end_.heading = *final_heading_;
}

double Route::length() const {
  double length = 0;
  for (const RouteLeg& leg : legs_) length += leg.line.length();
  return length;
}

}  // namespace wend
