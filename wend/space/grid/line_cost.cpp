#include "wend/space/grid/line_cost.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace wend {
namespace {

double multiplier_along(const FreeSpace& space, Cell cell) {
  const double terrain = space.terrain(cell);
  const Robot& robot = space.robot();
  if (robot.clearance_distance == 0 || space.passable(cell)) return terrain;
  return terrain * (1 + robot.clearance_cost);
}

/// The mean multiplier along a line of dx by dy cells. Crossings are compared as whole numbers, so that a line
/// through a corner of cells enters none of the two beside it.
double mean_multiplier(const FreeSpace& space, Cell from, Cell to, std::int64_t dx,
                       std::int64_t dy) {
  const int step_x = to.x < from.x ? -1 : 1;
  const int step_y = to.y < from.y ? -1 : 1;
  double mean = 0;
  double share = 0;  // of the line, up to the cell
  Cell cell = from;
  for (std::int64_t i = 0, j = 0; i < dx || j < dy;) {  // borders crossed, upright and flat ones
    const std::int64_t upright = (2 * i + 1) * dy;
    const std::int64_t flat = (2 * j + 1) * dx;
    const bool over_upright = j == dy || (i < dx && upright <= flat);
    const bool over_flat = i == dx || (j < dy && flat <= upright);
    const double crossing = over_upright
                                ? static_cast<double>(2 * i + 1) / (2 * static_cast<double>(dx))
                                : static_cast<double>(2 * j + 1) / (2 * static_cast<double>(dy));
    mean += (crossing - share) * multiplier_along(space, cell);
    share = crossing;
    if (over_upright) {
      cell.x += step_x;
      ++i;
    }
    if (over_flat) {
      cell.y += step_y;
      ++j;
    }
  }
  return mean + (1 - share) * multiplier_along(space, cell);
}

}  // namespace

double line_cost(const FreeSpace& space, Cell from, Cell to) {
  const std::int64_t dx = std::abs(to.x - from.x);
  const std::int64_t dy = std::abs(to.y - from.y);
  const double length = std::sqrt(static_cast<double>(dx * dx + dy * dy));
  return space.uniform_terrain() ? length : length * mean_multiplier(space, from, to, dx, dy);
}

double any_angle_path_cost(const FreeSpace& space, std::span<const Cell> cells) {
  double cost = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) cost += line_cost(space, cells[i - 1], cells[i]);
  return cost;
}

}  // namespace wend
