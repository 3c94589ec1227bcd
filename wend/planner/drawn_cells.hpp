#pragma once

// The passable cells of a FreeSpace as drawn, row 0 on top, and how a map's cells turn
// into them. What plans on bits alone then gives the same path on the same picture, whichever way
// the map's y points.

#include <algorithm>

#include "wend/geometry/cell.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

inline BitGrid drawn_passable(const FreeSpace& space) {
  const BitGrid& passable = space.passable();
  if (!space.map().frame().y_up) return passable;
  BitGrid drawn(passable.width(), passable.height());
  for (int y = 0; y < passable.height(); ++y) {
    const auto from = passable.row_words(passable.height() - 1 - y);
    std::copy(from.begin(), from.end(), drawn.row_words(y).begin());
  }
  return drawn;
}

/// A cell of the map as drawn, and back.
inline Cell drawn_cell(const FreeSpace& space, Cell cell) {
  return space.map().frame().y_up ? Cell{cell.x, space.height() - 1 - cell.y} : cell;
}

}  // namespace wend
