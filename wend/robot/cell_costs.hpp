#pragma once

// CellCosts: what a cell costs a robot: the map's terrain, and more near obstacles. A pure function of the
// terrain, the clearance of the cell and the robot, so that any part of a map can be computed on its own.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/map/capped_distances.hpp"
#include "wend/map/cost_map.hpp"
#include "wend/map/map_edit.hpp"
#include "wend/map/obstacles.hpp"
#include "wend/robot/footprint.hpp"

namespace wend {

struct Robot;

/// A robot's radius as a squared distance in half-cells, above 0: a point must still not be in a square.
/// The largest robot may stand where there is no obstacle. Radii that are whole half-cells up to rounding
/// are rounded to them.
double least_squared_half_cells(double radius_in_cells);

class CellCosts {
 public:
  CellCosts(const Robot& robot, double resolution);

  /// Does a clearance cost more than the terrain anywhere?
  bool raise() const { return distance_ > 0 && cost_ > 0; }

  /// The factor on the terrain at a clearance in squared half-cells; 1 where the robot cannot be.
  double factor(std::uint32_t clearance) const {
    return clearance < factors_.size() ? factors_[clearance] : computed_factor(clearance);
  }

  /// Puts the steps of cells in the place of their clearances. The terrain is empty where it is 1.
  void price(std::span<const double> terrain, std::span<std::uint32_t> clearances) const;

  /// Is every cost less than 2^16 on a map whose terrain is less than 256, and with such a terrain?
  bool stay_in_range(double terrain) const {
    return terrain < 256 && 256 * (1 + std::max(cost_, 0.0)) < CostMap::kLargest;
  }

  /// The steps of a cell; CostMap::kMost if it costs more than can be stored.
  std::uint32_t steps(double terrain, std::uint32_t clearance) const {
    if (terrain != 1) return rounded(terrain * factor(clearance));
    if (clearance < steps_.size()) return steps_[clearance];
    return clearance >= far_ ? CostMap::kOne : rounded(computed_factor(clearance));
  }

 private:
  static std::uint32_t rounded(double multiplier) {
    return CostMap::rounded(multiplier).value_or(CostMap::kMost);
  }
  double computed_factor(std::uint32_t clearance) const;

  double least_;     // the clearance that the robot needs
  double radius_;    // cells
  double distance_;  // cells
  double cost_;
  std::uint32_t far_ = 0;             // no clearance from here on costs more
  std::vector<double> factors_;       // by clearance, as far as that is short
  std::vector<std::uint32_t> steps_;  // the same for a terrain of 1
};

/// The costs of all cells, or the error of a cell that costs more than can be stored. The distances are as far
/// as the robot needs them, or empty: then those of the obstacles are used. O(cells).
Expected<CostMap, Error> cell_costs(const Obstacles& obstacles, const CappedDistances& distances,
                                    const CellCosts& costs,
                                    DeadlineCheck& stop = DeadlineCheck::never());

/// Computes the costs in a box of the map again. None of them may be more than can be stored. O(cells of the
/// box).
void set_cell_costs(const Obstacles& obstacles, const CappedDistances& distances,
                    const CellCosts& costs, const CellBox& box, CostMap& map);

/// The greatest new terrain of an edit, at least 1.
double greatest_terrain(const MapEdit& edit);

}  // namespace wend
