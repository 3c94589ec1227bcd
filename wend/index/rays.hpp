#pragma once

// Rays: how far a straight line of sight goes from a cell, 64 cells at a time.
//
// A ray passes cells until it stops: at a blocked cell, at the map's edge, or at a corner that is
// a stop for it.

#include <array>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

class Rays {
 public:
  enum class Stops {
    every_corner,
    jump_points,  // corners that turn a shortest path that comes this way: see jump_directions()
  };

  /// O(cells); half a byte a cell.
  Rays(const BitGrid& passable, Stops stops);

  /// Where the ray from a cell in a straight direction stops: the first cell after `from` that it
  /// does not pass. It may lie on the border around the map.
  Cell end(Cell from, Direction straight) const;

 private:
  std::array<BitGrid, 4> passing_;  // by Direction / 2; those of columns lie on their side
};

}  // namespace wend
