#include "wend/robot/cell_costs.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "wend/base/parse.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

constexpr double kMostFactors = 1 << 16;

// Metres divided by a resolution are rarely exact.
constexpr double kRelativeRounding = 1e-9;

Error too_dear(Cell cell, double multiplier) {
  return {Status::unsupported_map,
          "cell (" + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ") costs " +
              format_number(multiplier) + " times its length: the most is " +
              format_number(CostMap::kLargest) + "; lower the terrain or the clearance cost",
          "terrain"};
}

}  // namespace

double least_squared_half_cells(double radius_in_cells) {
  const double exact = 4 * radius_in_cells * radius_in_cells;
  return std::clamp<double>(exact * (1 - kRelativeRounding), std::numeric_limits<double>::min(),
                            kNoObstacle);
}

CellCosts::CellCosts(const Robot& robot, double resolution)
    : least_(least_squared_half_cells(robot.footprint.circumscribed_radius() / resolution)),
      radius_(robot.footprint.circumscribed_radius() / resolution),
      distance_(robot.clearance_distance / resolution),
      cost_(robot.clearance_cost) {
  if (!raise()) return;
  const double reach = 2 * (radius_ + distance_) + 1;  // half-cells
  const auto count = static_cast<std::uint32_t>(std::min(reach * reach, kMostFactors));
  factors_.reserve(count);
  for (std::uint32_t clearance = 0; clearance < count; ++clearance) {
    factors_.push_back(computed_factor(clearance));
  }
}

double CellCosts::computed_factor(std::uint32_t clearance) const {
  if (!raise() || clearance < least_) return 1;
  const double from_edge = std::fmax(0, distance_in_cells(clearance) - radius_);
  if (from_edge >= distance_) return 1;
  const double inwards = 1 - from_edge / distance_;
  return 1 + cost_ * inwards * inwards;
}

Expected<CostMap, Error> cell_costs(const Obstacles& obstacles, const CellCosts& costs) {
  const GridMap& map = obstacles.map();
  if (map.uniform_terrain() && !costs.raise()) return CostMap();
  const auto& clearance = obstacles.squared_half_cell_clearance();
  std::optional<Cell> dear;
  CostMap made(map.width(), map.height(), [&](Cell cell) {
    const std::uint32_t steps = costs.steps(map.terrain(cell), clearance[cell]);
    if (steps == CostMap::kMost && !dear) dear = cell;
    return steps;
  });
  if (dear) {
    return Unexpected<Error>(too_dear(*dear, map.terrain(*dear) * costs.factor(clearance[*dear])));
  }
  return made;
}

}  // namespace wend
