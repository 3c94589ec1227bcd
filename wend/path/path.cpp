#include "wend/path/path.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

/// The arc of a car from a pose to a pose; nothing if it would end with another heading.
std::optional<Arc> car_arc(const Pose& from, const Pose& to) {
  constexpr double kRounding = 1e-6;
  const Arc arc = arc_to(from, to.point());
  const double error = normalized_angle(from.heading + arc.turn() - to.heading);
  return std::abs(error) < kRounding ? std::optional(arc) : std::nullopt;
}

Arc way_between(const Pose& from, const Pose& to) {
  const auto arc = car_arc(from, to);
  return arc ? *arc : way_of_base(segment_between(from, to));
}

/// Straight steps and diagonal ones are counted, so that the sum is exact.
double length_of(std::span<const Cell> cells) {
  std::uint64_t straight = 0;
  std::uint64_t diagonal = 0;
  double other = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const int dx = std::abs(cells[i].x - cells[i - 1].x);
    const int dy = std::abs(cells[i].y - cells[i - 1].y);
    if (dx + dy == 1) {
      ++straight;
    } else if (dx == 1 && dy == 1) {
      ++diagonal;
    } else {
      other += std::hypot(dx, dy);
    }
  }
  return static_cast<double>(straight) + std::numbers::sqrt2 * static_cast<double>(diagonal) +
         other;
}

double length_of(std::span<const Point> waypoints) {
  double length = 0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    length += distance(waypoints[i - 1], waypoints[i]);
  }
  return length;
}

double length_of(const JoinedPoses& poses) {
  double length = 0;
  for (std::size_t i = 0; i < poses.segment_count(); ++i) {
    length += std::abs(poses.segment(i).length);
  }
  return length;
}

/// Each heads towards the next one, the last like the one before it.
std::vector<Pose> heading_along(std::span<const Point> points) {
  std::vector<Pose> poses;
  poses.reserve(points.size());
  for (const Point point : points) {
    if (!poses.empty()) {
      Pose& last = poses.back();
      if (point != last.point()) last.heading = std::atan2(point.y - last.y, point.x - last.x);
    }
    poses.push_back({point.x, point.y, poses.empty() ? 0 : poses.back().heading});
  }
  return poses;
}

}  // namespace

Segment JoinedPoses::segment(std::size_t i) const {
  const Pose& from = poses_[i];
  const Pose& to = poses_[i + 1];
  const auto arc = car_arc(from, to);
  return arc ? Segment{from, arc->length, arc->turn(), 0} : segment_between(from, to);
}

Path Path::through(std::vector<Pose> poses) {
  Path path;
  path.poses_ = std::move(poses);
  return path;
}

Path Path::along(std::vector<Point> waypoints) {
  Path path;
  path.waypoints_ = std::move(waypoints);
  return path;
}

bool Path::of_steps() const {
  const auto far_apart = [](Cell a, Cell b) {
    return std::abs(a.x - b.x) > 1 || std::abs(a.y - b.y) > 1;
  };
  return !cells_.empty() && std::ranges::adjacent_find(cells(), far_apart) == cells().end();
}

std::vector<Point> Path::points() const {
  if (!waypoints_.empty()) return waypoints_;
  std::vector<Point> points;
  points.reserve(size());
  for (const Cell cell : cells()) points.push_back(centre_of(cell));
  for (const Pose& pose : poses_) points.push_back(pose.point());
  return points;
}

double Path::length() const {
  return visit([](std::span<const Cell> cells) { return length_of(cells); },
               [](std::span<const Point> waypoints) { return length_of(waypoints); },
               [](const JoinedPoses& poses) { return length_of(poses); });
}

std::vector<Pose> Path::poses() const { return driven() ? poses_ : heading_along(points()); }

std::vector<Arc> Path::arcs() const {
  std::vector<Arc> arcs;
  if (empty()) return arcs;
  arcs.reserve(size() - 1);
  const std::vector<Pose> poses = this->poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Pose& from = poses[i - 1];
    arcs.push_back(driven() ? way_between(from, poses[i])
                            : Arc{from, distance(from.point(), poses[i].point()), 0});
  }
  return arcs;
}

std::vector<Segment> Path::segments() const {
  std::vector<Segment> segments;
  if (empty()) return segments;
  segments.reserve(size() - 1);
  if (driven()) {
    const JoinedPoses joined(poses_);
    for (std::size_t i = 0; i < joined.segment_count(); ++i) segments.push_back(joined.segment(i));
    return segments;
  }
  const std::vector<Pose> poses = this->poses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    segments.emplace_back(poses[i - 1], distance(poses[i - 1].point(), poses[i].point()), 0, 0);
  }
  return segments;
}

std::vector<MapPoint> Path::points_in_metres(const Frame& frame) const {
  std::vector<MapPoint> metres;
  for (const Point point : points()) metres.push_back(frame.to_metres(point));
  return metres;
}

void Path::clear() {
  cells_.clear();
  poses_.clear();
  waypoints_.clear();
}

void Path::reverse() {
  std::ranges::reverse(cells_.cells());
  std::reverse(poses_.begin(), poses_.end());
  std::reverse(waypoints_.begin(), waypoints_.end());
}

}  // namespace wend
