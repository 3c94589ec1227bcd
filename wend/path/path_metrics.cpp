#include "wend/path/path_metrics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "wend/geometry/angle.hpp"
#include "wend/map/arc_clearance.hpp"
#include "wend/map/way_clearance.hpp"

namespace wend {
namespace {

double turning_of(std::span<const Cell> cells) {
  double turning = 0;
  std::optional<double> heading;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i] == cells[i - 1]) continue;
    const double next = std::atan2(cells[i].y - cells[i - 1].y, cells[i].x - cells[i - 1].x);
    if (heading) turning += std::abs(normalized_angle(next - *heading));
    heading = next;
  }
  return turning;
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

PathMetrics measure_cells(const Path& path, const FreeSpace& space) {
  const auto cells = path.cells();
  PathMetrics metrics{.length = path.length(),
                      .turning = turning_of(cells),
                      .smallest_clearance = space.clearance(cells.front())};
  Mean clearance(space.clearance(cells.front()));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const Cell from = cells[i - 1];
    const Cell to = cells[i];
    if (from == to) continue;
    metrics.smallest_clearance =
        std::min(metrics.smallest_clearance, way_clearance(space, from, to));
    clearance.go(distance(centre_of(from), centre_of(to)), space.clearance(to));
  }
  metrics.mean_clearance = clearance.value();
  return metrics;
}

double clearance_at(const FreeSpace& space, Point point) {
  return arc_clearance(space, {{point.x, point.y, 0}, 0, 0});
}

PathMetrics measure_arcs(const Path& path, const FreeSpace& space) {
  const double at_start = clearance_at(space, path.poses().front().point());
  PathMetrics metrics{.length = path.length(), .smallest_clearance = at_start};
  Mean clearance(at_start);
  double last_length = 0;
  for (const Arc& arc : path.arcs()) {
    if (arc.length == 0) continue;
    const double length = std::abs(arc.length);
    metrics.turning += std::abs(arc.turn());
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

PathMetrics measure(const Path& path, const FreeSpace& space) {
  assert(!path.empty());
  return path.driven() ? measure_arcs(path, space) : measure_cells(path, space);
}

}  // namespace wend
