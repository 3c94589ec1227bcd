#include "wend/path/path_metrics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "wend/geometry/angle.hpp"
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

}  // namespace

PathMetrics measure(const Path& path, const FreeSpace& space) {
  assert(!path.empty());
  const auto cells = path.cells();
  PathMetrics metrics{.length = path.length(),
                      .turning = turning_of(cells),
                      .smallest_clearance = space.clearance(cells.front()),
                      .mean_clearance = space.clearance(cells.front())};
  double sum = 0;  // of clearance over length
  double length = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const Cell from = cells[i - 1];
    const Cell to = cells[i];
    if (from == to) continue;
    metrics.smallest_clearance =
        std::min(metrics.smallest_clearance, way_clearance(space, from, to));
    const double step = distance(centre_of(from), centre_of(to));
    sum += step * (space.clearance(from) + space.clearance(to)) / 2;
    length += step;
  }
  if (length > 0) metrics.mean_clearance = sum / length;
  return metrics;
}

}  // namespace wend
