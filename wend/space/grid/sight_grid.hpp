#pragma once

// SightGrid: the cells of a FreeSpace, and which of them see each other: the robot fits along the line
// from centre to centre. For planners whose paths turn at any angle. CostSightGrid is the same on cells with
// costs, where a line costs what line_cost() says.
//
//   const wend::SightGrid grid(space);
//   if (grid.sees(grid.state({0, 0}), grid.state({5, 2}))) length = std::sqrt(29);
//
// A point may touch the corner of an obstacle; it passes between two that touch at a corner only where
// the corner rule is `both`. Steps lead to all neighbours in sight. A polygon counts as its circumscribed disc.

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "wend/robot/sweep/fits_along.hpp"
#include "wend/space/grid/cell_sight.hpp"
#include "wend/space/grid/grid_space.hpp"
#include "wend/space/grid/line_cost.hpp"

namespace wend {

/// Steps that cost their length, in cells.
struct LengthSteps {
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;

  explicit LengthSteps(const FreeSpace& /*space*/) {}

  Cost cost(const GridState& /*from*/, const GridState& /*to*/, bool diagonal) const {
    return diagonal ? std::numbers::sqrt2 : 1;
  }
};

/// Steps that cost their length times the mean multiplier of the two cells.
struct CostSteps {
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;

  explicit CostSteps(const FreeSpace& space) : costs(&space.costs()) {}

  Cost cost(const GridState& from, const GridState& to, bool diagonal) const {
    const double mean = (costs->multiplier(from.cell) + costs->multiplier(to.cell)) / 2;
    return diagonal ? std::numbers::sqrt2 * mean : mean;
  }

  const CostMap* costs;  // owned by the FreeSpace that the space holds
};

extern template class GridSpace<LengthSteps>;
extern template class GridSpace<CostSteps>;

template <class Steps>
class SightSpace : public GridSpace<Steps> {
 public:
  using State = GridState;
  /// May a line cost more than another way? Else the straight line is the shortest.
  static constexpr bool kCosts = std::is_same_v<Steps, CostSteps>;

  explicit SightSpace(FreeSpace space, CornerRule rule = CornerRule::none)
      : SightSpace(std::move(space), steps_in_sight(rule)) {}

  /// What the line between the centres of two cells costs, in cells. Without costs its length, rounded once.
  double distance(const State& a, const State& b) const {
    if constexpr (kCosts) return line_cost(this->free_space(), a.cell, b.cell);
    const double dx = a.cell.x - b.cell.x;
    const double dy = a.cell.y - b.cell.y;
    return std::sqrt(dx * dx + dy * dy);
  }

  /// As disc_fits_along().
  bool sees(const State& a, const State& b) const {
    const FreeSpace& space = this->free_space();
    if (space.is_point()) {
      return cells_in_sight(space.obstacles().blocked(), a.cell, b.cell, adjacency_);
    }
    return disc_fits_along(space, Line{centre_of(a.cell), centre_of(b.cell)}, adjacency_);
  }

 private:
  SightSpace(FreeSpace space, GridMoves moves)
      : GridSpace<Steps>(std::move(space), moves), adjacency_(moves.adjacency()) {}

  static GridMoves steps_in_sight(CornerRule rule) {
    return {Connectivity::eight, rule == CornerRule::both ? rule : CornerRule::one};
  }

  Adjacency adjacency_;
};

using SightGrid = SightSpace<LengthSteps>;
using CostSightGrid = SightSpace<CostSteps>;

}  // namespace wend
