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

Segment segment_of(const Pose& from, const Pose& to) {
  const auto arc = car_arc(from, to);
  return arc ? Segment{from, arc->length, arc->turn(), 0} : segment_between(from, to);
}

}  // namespace

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
  if (cells_.empty()) {
    double length = 0;
    for (std::size_t i = 1; i < waypoints_.size(); ++i) {
      length += distance(waypoints_[i - 1], waypoints_[i]);
    }
    if (driven()) {
      for (const Arc& arc : arcs()) length += std::abs(arc.length);
    }
    return length;
  }
  std::uint64_t straight = 0;
  std::uint64_t diagonal = 0;
  double other = 0;
  const std::span<const Cell> steps = cells();
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const int dx = std::abs(steps[i].x - steps[i - 1].x);
    const int dy = std::abs(steps[i].y - steps[i - 1].y);
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

std::vector<Pose> Path::poses() const {
  if (driven()) return poses_;
  std::vector<Pose> poses;
  poses.reserve(size());
  for (const Point point : points()) {
    if (!poses.empty()) {
      Pose& last = poses.back();
      if (point != last.point()) last.heading = std::atan2(point.y - last.y, point.x - last.x);
    }
    poses.push_back({point.x, point.y, poses.empty() ? 0 : poses.back().heading});
  }
  return poses;
}

std::vector<Arc> Path::arcs() const {
  std::vector<Arc> arcs;
  if (empty()) return arcs;
  const std::vector<Pose> poses = this->poses();
  arcs.reserve(poses.size() - 1);
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
  const std::vector<Pose> poses = this->poses();
  segments.reserve(poses.size() - 1);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Pose& from = poses[i - 1];
    segments.push_back(driven() ? segment_of(from, poses[i])
                                : Segment{from, distance(from.point(), poses[i].point()), 0, 0});
  }
  return segments;
}

std::vector<Point> Path::points_in_metres(const Frame& frame) const {
  std::vector<Point> points = this->points();
  for (Point& point : points) point = frame.to_metres(point);
  return points;
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
