#include "wend/path/path_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/line.hpp"
#include "wend/path/length_fault.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"

namespace wend {
namespace {

/// 1 / cos - 1 of an angle, by its tangent: without rounding where that is small.
double secant_less_one(double tangent) {
  return tangent * tangent / (std::sqrt(1 + tangent * tangent) + 1);
}

double half_turn_tangent(Point from, Point at, Point to, double lengths) {
  const double cross = (at.x - from.x) * (to.y - at.y) - (at.y - from.y) * (to.x - at.x);
  const double dot = (at.x - from.x) * (to.x - at.x) + (at.y - from.y) * (to.y - at.y);
  if (cross == 0) return dot > 0 ? 0 : std::numeric_limits<double>::infinity();
  // tan(t / 2) = sin t / (1 + cos t), or (1 - cos t) / sin t where that is the exact one.
  const double sine = std::abs(cross);
  return dot > 0 ? sine / (lengths + dot) : (lengths - dot) / sine;
}

double angle_of(Point a, Point b, Point c) {
  return std::abs(normalized_angle(Line{b, c}.heading() - Line{a, b}.heading()));
}

void add_bend(PathMetrics& metrics, double radius, double rounded_radius) {
  metrics.smallest_turning_radius = std::min(metrics.smallest_turning_radius, radius);
  metrics.rounded_turning_radius = std::min(metrics.rounded_turning_radius, rounded_radius);
}

/// Where lines meet. Points on top of each other count once.
void measure_corners(const Path& path, PathMetrics& metrics) {
  std::vector<Point> points = path.points();
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (std::size_t i = 2; i < points.size(); ++i) {
    const Point a = points[i - 2];
    const Point b = points[i - 1];
    const Point c = points[i];
    metrics.turning += angle_of(a, b, c);
    add_bend(metrics, Corner(a, b, c).radius(0), Corner(a, b, c).radius(metrics.corner_rounding));
  }
}

/// The bends of a path of poses: its arcs and its turns in place.
void measure_arc_bends(const JoinedPoses& drive, PathMetrics& metrics) {
  for (std::size_t i = 0; i < drive.segment_count(); ++i) {
    const Arc arc = drive.arc(i);
    if (arc.length == 0) {
      const double turn = drive.segment(i).turn;
      if (turn == 0) continue;
      metrics.turning += std::abs(turn);
      add_bend(metrics, 0, 0);
    } else {
      metrics.turning += std::abs(arc.turn());
      add_bend(metrics, 1 / std::abs(arc.curvature), 1 / std::abs(arc.curvature));
    }
  }
}

/// The mean over the length of a way of what is known at points of it, linear between them.
class Mean {
 public:
  explicit Mean(double at_start) : last_(at_start) {}

  void go(double length, double value) {
    sum_ += length * (last_ + value) / 2;
    length_ += length;
    last_ = value;
  }

  double value() const { return length_ > 0 ? sum_ / length_ : last_; }

 private:
  double last_;
  double sum_ = 0;
  double length_ = 0;
};

double clearance_at(const FreeSpace& space, Point point) {
  return arc_clearance(space, {{point.x, point.y, 0}, 0, 0});
}

/// Neighbours on the map have known clearances; a longer line is looked at once a cell.
void go_straight(Mean& clearance, const FreeSpace& space, Cell from, Cell to) {
  const Line line{centre_of(from), centre_of(to)};
  const bool neighbours = std::abs(to.x - from.x) <= 1 && std::abs(to.y - from.y) <= 1;
  const int pieces = neighbours ? 1 : static_cast<int>(std::ceil(line.length()));
  for (int i = 1; i < pieces; ++i) {
    clearance.go(line.length() / pieces,
                 clearance_at(space, line.at(static_cast<double>(i) / pieces)));
  }
  clearance.go(line.length() / pieces, space.clearance(to));
}

PathMetrics measure_cells(std::span<const Cell> cells, const Path& path, const FreeSpace& space) {
  PathMetrics metrics;
  metrics.length = path.length();
  metrics.smallest_clearance = space.clearance(cells.front());
  Mean clearance(space.clearance(cells.front()));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const Cell from = cells[i - 1];
    const Cell to = cells[i];
    if (from == to) continue;
    metrics.smallest_clearance =
        std::min(metrics.smallest_clearance, way_clearance(space, from, to));
    go_straight(clearance, space, from, to);
  }
  metrics.mean_clearance = clearance.value();
  return metrics;
}

PathMetrics measure_arcs(const Path& path, const FreeSpace& space) {
  const double at_start = clearance_at(space, path.poses().front().point());
  PathMetrics metrics;
  metrics.length = path.length();
  metrics.smallest_clearance = at_start;
  Mean clearance(at_start);
  double last_length = 0;
  for (const Arc& arc : path.arcs()) {
    if (arc.length == 0) continue;
    const double length = std::abs(arc.length);
    metrics.reversals += arc.length * last_length < 0 ? 1 : 0;
    last_length = arc.length;
    metrics.smallest_clearance = std::min(metrics.smallest_clearance, arc_clearance(space, arc));
    const int pieces = static_cast<int>(std::ceil(length));
    for (int i = 1; i <= pieces; ++i) {
      clearance.go(length / pieces, clearance_at(space, point_on(arc, arc.length * i / pieces)));
    }
  }
  metrics.mean_clearance = clearance.value();
  return metrics;
}

}  // namespace

Corner::Corner(Point from, Point at, Point to) {
  const double before = distance(from, at);
  const double after = distance(at, to);
  half_turn_ = wend::half_turn_tangent(from, at, to, before * after);
  constexpr double kStraight = 1e-9;
  if (half_turn_ < kStraight) half_turn_ = 0;
  tangent_ = std::min(before, after) / 2;
}

double Corner::radius(double window) const {
  if (half_turn_ == 0) return std::numeric_limits<double>::infinity();
  if (std::isinf(half_turn_)) return 0;
  return std::min(tangent_ / half_turn_, window / secant_less_one(half_turn_));
}

double Corner::widest_half_turn(double radius, double window) const {
  const double secant = 1 + window / radius;
  return std::min(tangent_ / radius, std::sqrt(secant * secant - 1));
}

std::vector<Metric> metrics_of(const PathMetrics& metrics) {
  using enum MetricUnit;
  return {
      {"length", cells, "the length of the lines or arcs", metrics.length},
      {"turning", radians, "the sum of all changes of heading", metrics.turning},
      {"smallest_turning_radius", cells,
       "for a path of poses, the radius of its tightest arc; for a path of lines, 0 if it has a "
       "corner, because a robot that steers cannot follow a corner",
       metrics.smallest_turning_radius},
      {"rounded_turning_radius", cells,
       "the same, with each corner replaced by an arc that stays within `corner_rounding` of the "
       "corner, and within half of its two lines",
       metrics.rounded_turning_radius},
      {"corner_rounding", cells,
       "how far from a corner its arc may pass; it is given, not measured",
       metrics.corner_rounding},
      {"smallest_clearance", cells,
       "the exact distance from any point of the path to the nearest obstacle",
       metrics.smallest_clearance},
      {"mean_clearance", cells, "the mean of that distance over the length",
       metrics.mean_clearance},
      {"reversals", count, "the number of changes between ahead and reverse",
       static_cast<double>(metrics.reversals)},
  };
}

Expected<PathMetrics, Error> measure(const Path& path, const FreeSpace& space,
                                     double corner_rounding) {
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  if (auto fault = fault_of_length("corner_rounding", corner_rounding)) {
    return Unexpected<Error>(*std::move(fault));
  }
  const auto on_map = [&](Cell cell) { return space.contains(cell); };
  PathMetrics metrics = path.visit(
      [&](std::span<const Cell> cells) {
        return std::ranges::all_of(cells, on_map) ? measure_cells(cells, path, space)
                                                  : measure_arcs(path, space);
      },
      [&](const auto&) { return measure_arcs(path, space); });
  metrics.corner_rounding = corner_rounding;
  metrics.smallest_turning_radius = std::numeric_limits<double>::infinity();
  metrics.rounded_turning_radius = std::numeric_limits<double>::infinity();
  path.visit([&](const JoinedPoses& drive) { measure_arc_bends(drive, metrics); },
             [&](const auto&) { measure_corners(path, metrics); });
  return metrics;
}

}  // namespace wend
