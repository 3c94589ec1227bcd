#pragma once

// SightGrid: the cells of a FreeSpace, and which of them see each other: the robot fits along the line
// from centre to centre. For planners whose paths turn at any angle.
//
//   const wend::SightGrid grid(space);
//   if (grid.sees(grid.state({0, 0}), grid.state({5, 2}))) length = std::sqrt(29);
//
// A point may touch the corner of an obstacle; it passes between two that touch at a corner only where
// the corner rule is `both`. Steps lead to all neighbours in sight. A polygon counts as its circumscribed disc. Terrain is not considered.

#include <cmath>
#include <numbers>
#include <utility>

#include "wend/robot/fits_along.hpp"
#include "wend/space/grid/grid_space.hpp"

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

extern template class GridSpace<LengthSteps>;

class SightGrid : public GridSpace<LengthSteps> {
 public:
  explicit SightGrid(FreeSpace space, CornerRule rule = CornerRule::none)
      : SightGrid(std::move(space), steps_in_sight(rule)) {}

  /// Between the centres of two cells, in cells; rounded once.
  static double distance(const State& a, const State& b) {
    const double dx = a.cell.x - b.cell.x;
    const double dy = a.cell.y - b.cell.y;
    return std::sqrt(dx * dx + dy * dy);
  }

  /// As disc_fits_along().
  bool sees(const State& a, const State& b) const {
    return disc_fits_along(free_space(), Line{centre_of(a.cell), centre_of(b.cell)}, adjacency_);
  }

 private:
  SightGrid(FreeSpace space, GridMoves moves)
      : GridSpace(std::move(space), moves), adjacency_(moves.adjacency()) {}

  static GridMoves steps_in_sight(CornerRule rule) {
    return {Connectivity::eight, rule == CornerRule::both ? rule : CornerRule::one};
  }

  Adjacency adjacency_;
};

}  // namespace wend
