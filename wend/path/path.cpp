#include "wend/path/path.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// The arc of a car from a pose to a pose; nothing if it would end with another heading.
std::optional<Arc> car_arc(const Pose& from, const Pose& to) {
  constexpr double kRounding = 1e-6;
  const Arc arc = arc_to(from, to.point());
  const double error = normalized_angle(from.heading + arc.turn() - to.heading);
  return std::abs(error) < kRounding ? std::optional(arc) : std::nullopt;
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
      other += hypotenuse(dx, dy);
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
      if (point != last.point()) last.heading = arc_tangent(point.y - last.y, point.x - last.x);
    }
    poses.push_back({point.x, point.y, poses.empty() ? 0 : poses.back().heading});
  }
  return poses;
}

/// Calls line(from, length) for the lines from pose to pose.
template <class Line>
void for_each_line(const std::vector<Pose>& poses, Line&& line) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    line(poses[i - 1], distance(poses[i - 1].point(), poses[i].point()));
  }
}

}  // namespace

Segment JoinedPoses::segment(std::size_t i) const {
  const Pose& from = poses_[i];
  const Pose& to = poses_[i + 1];
  const auto arc = car_arc(from, to);
  return arc ? Segment{from, arc->length, arc->turn(), 0} : segment_between(from, to);
}

Arc JoinedPoses::arc(std::size_t i) const {
  const auto arc = car_arc(poses_[i], poses_[i + 1]);
  return arc ? *arc : way_of_base(segment_between(poses_[i], poses_[i + 1]));
}

Path Path::through(std::vector<Pose> poses) {
  Path path;
  path.joints_ = std::move(poses);
  return path;
}

Path Path::along(std::vector<Point> waypoints) {
  Path path;
  path.joints_ = std::move(waypoints);
  return path;
}

Path Path::over_cells(std::vector<Point> waypoints) {
  Path path = along(std::move(waypoints));
  path.over_cells_ = true;
  return path;
}

std::vector<Cell> Path::passed_cells() const {
  std::vector<Cell> passed;
  for (const Point point : points()) {
    const Cell cell = cell_at(point);
    if (passed.empty() || passed.back() != cell) passed.push_back(cell);
  }
  return passed;
}

bool Path::of_steps() const {
  const auto far_apart = [](Cell a, Cell b) {
    return std::abs(a.x - b.x) > 1 || std::abs(a.y - b.y) > 1;
  };
  return !cells().empty() && std::ranges::adjacent_find(cells(), far_apart) == cells().end();
}

std::vector<Point> Path::points() const {
  std::vector<Point> points(waypoints().begin(), waypoints().end());
  points.reserve(size());
  for (const Cell cell : cells()) points.push_back(centre_of(cell));
  for (const Pose& pose : driven_poses()) points.push_back(pose.point());
  return points;
}

double Path::length() const {
  return visit([](std::span<const Cell> cells) { return length_of(cells); },
               [](std::span<const Point> waypoints) { return length_of(waypoints); },
               [](const JoinedPoses& poses) { return length_of(poses); });
}

std::vector<Pose> Path::poses() const {
  const auto headed = [&](const auto&) { return heading_along(points()); };
  return visit(headed, [](const JoinedPoses& joined) {
    return std::vector<Pose>(joined.poses().begin(), joined.poses().end());
  });
}

std::vector<Arc> Path::arcs() const {
  std::vector<Arc> arcs;
  const auto add_lines = [&](const auto&) {
    for_each_line(poses(),
                  [&](const Pose& from, double length) { arcs.push_back({from, length, 0}); });
  };
  visit(add_lines, [&](const JoinedPoses& joined) {
    for (std::size_t i = 0; i < joined.segment_count(); ++i) arcs.push_back(joined.arc(i));
  });
  return arcs;
}

std::vector<Segment> Path::segments() const {
  std::vector<Segment> segments;
  const auto add_lines = [&](const auto&) {
    for_each_line(poses(), [&](const Pose& from, double length) {
      segments.emplace_back(from, length, 0, 0);
    });
  };
  visit(add_lines, [&](const JoinedPoses& joined) {
    for (std::size_t i = 0; i < joined.segment_count(); ++i) segments.push_back(joined.segment(i));
  });
  return segments;
}

std::vector<MapPoint> Path::points_in_metres(const Frame& frame) const {
  std::vector<MapPoint> metres;
  for (const Point point : points()) metres.push_back(frame.to_metres(point));
  return metres;
}

void Path::clear() {
  over_cells_ = false;
  std::visit([](auto& joints) { joints.clear(); }, joints_);
}

void Path::reverse() {
  if (auto* const cells = std::get_if<CellBuffer>(&joints_)) std::ranges::reverse(cells->cells());
  if (auto* const points = std::get_if<std::vector<Point>>(&joints_)) std::ranges::reverse(*points);
  if (auto* const poses = std::get_if<std::vector<Pose>>(&joints_)) std::ranges::reverse(*poses);
}

}  // namespace wend
