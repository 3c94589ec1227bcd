#pragma once

// CellCosts: what a cell costs a robot: the map's terrain, and more near obstacles. A pure function of the
// terrain, the clearance of the cell and the robot, so that any part of a map can be computed on its own.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/map/cost_map.hpp"
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

  /// The steps of a cell; CostMap::kMost if it costs more than can be stored.
  std::uint32_t steps(double terrain, std::uint32_t clearance) const {
    return CostMap::rounded(terrain * factor(clearance)).value_or(CostMap::kMost);
  }

 private:
  double computed_factor(std::uint32_t clearance) const;

  double least_;     // the clearance that the robot needs
  double radius_;    // cells
  double distance_;  // cells
  double cost_;
  std::vector<double> factors_;  // by clearance, as far as that is short
};

/// The costs of all cells, or the error of a cell that costs more than can be stored. O(cells).
Expected<CostMap, Error> cell_costs(const Obstacles& obstacles, const CellCosts& costs);

}  // namespace wend
