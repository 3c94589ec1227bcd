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

/// The clearance of each cell as far as costs depend on it; none if they do not.
class Clearances {
 public:
  Clearances(const Obstacles& obstacles, const CappedDistances& distances, const CellCosts& costs)
      : distances_(distances) {
    if (costs.raise() && distances.empty()) all_ = &obstacles.squared_half_cell_clearance();
  }

  std::uint32_t operator[](Cell cell) const {
    if (all_ != nullptr) return (*all_)[cell];
    return distances_.empty() ? kNoObstacle : distances_[cell];
  }

  /// The same for a whole row.
  void read_row(int y, std::span<std::uint32_t> clearances) const {
    if (all_ != nullptr) {
      std::ranges::copy(all_->row(y), clearances.begin());
    } else if (distances_.empty()) {
      std::ranges::fill(clearances, kNoObstacle);
    } else {
      distances_.read_row(y, clearances);
    }
  }

 private:
  const CappedDistances& distances_;
  const Grid<std::uint32_t>* all_ = nullptr;
};

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
  far_ = reach * reach < kMostFactors ? count : kNoObstacle;
  factors_.reserve(count);
  steps_.reserve(count);
  for (std::uint32_t clearance = 0; clearance < count; ++clearance) {
    factors_.push_back(computed_factor(clearance));
    steps_.push_back(rounded(factors_.back()));
  }
}

void CellCosts::price(std::span<const double> terrain, std::span<std::uint32_t> clearances) const {
  if (terrain.empty()) {
    for (std::uint32_t& each : clearances) each = steps(1, each);
  } else if (!raise()) {
    std::ranges::transform(terrain, clearances.begin(), rounded);
  } else {
    for (std::size_t i = 0; i < terrain.size(); ++i) {
      clearances[i] = steps(terrain[i], clearances[i]);
    }
  }
}

double CellCosts::computed_factor(std::uint32_t clearance) const {
  if (!raise() || clearance < least_) return 1;
  const double from_edge = std::fmax(0, distance_in_cells(clearance) - radius_);
  if (from_edge >= distance_) return 1;
  const double inwards = 1 - from_edge / distance_;
  return 1 + cost_ * inwards * inwards;
}

Expected<CostMap, Error> cell_costs(const Obstacles& obstacles, const CappedDistances& distances,
                                    const CellCosts& costs, DeadlineCheck& stop) {
  const GridMap& map = obstacles.map();
  if (map.uniform_terrain() && !costs.raise()) return CostMap(map.width(), map.height());
  const Clearances clearance(obstacles, distances, costs);
  std::optional<Cell> dear;
  const auto write_row = [&](int y, std::span<std::uint32_t> steps) {
    clearance.read_row(y, steps);
    costs.price(map.uniform_terrain() ? std::span<const double>() : map.terrain().row(y), steps);
    if (dear) return;
    const auto found = std::ranges::find(steps, CostMap::kMost);
    if (found != steps.end()) dear = Cell{static_cast<int>(found - steps.begin()), y};
  };
  CostMap made(map.width(), map.height(), write_row, stop);
  if (dear) {
    return Unexpected<Error>(too_dear(*dear, map.terrain(*dear) * costs.factor(clearance[*dear])));
  }
  return made;
}

void set_cell_costs(const Obstacles& obstacles, const CappedDistances& distances,
                    const CellCosts& costs, const CellBox& box, CostMap& map) {
  const GridMap& terrain = obstacles.map();
  if (terrain.uniform_terrain() && map.uniform() && !costs.raise()) return;
  const Clearances clearance(obstacles, distances, costs);
  for (int y = box.begin.y; y < box.end.y; ++y) {
    for (int x = box.begin.x; x < box.end.x; ++x) {
      map.set({x, y}, costs.steps(terrain.terrain({x, y}), clearance[{x, y}]));
    }
  }
}

double greatest_terrain(const MapEdit& edit) {
  double greatest = 1;
  for (const double terrain : edit.terrain.values()) greatest = std::max(greatest, terrain);
  for (const CellEdit& each : edit.cells) greatest = std::max(greatest, each.terrain.value_or(1));
  return greatest;
}

}  // namespace wend
