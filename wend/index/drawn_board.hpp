#pragma once

// The passable cells of a FreeSpace as a picture shows them, y down, whatever the file format says:
// so the same picture gives the same index and the same paths.

#include <algorithm>

#include "wend/map/bit_grid.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

/// Turns a cell of a map of that height into drawn coordinates, and back.
constexpr Cell drawn_cell(Cell cell, int height, bool y_up) {
  return {cell.x, y_up ? height - 1 - cell.y : cell.y};
}

inline BitGrid drawn_board(const FreeSpace& space) {
  const BitGrid& passable = space.passable();
  if (!space.map().frame().y_up) return passable;
  BitGrid drawn(passable.width(), passable.height());
  for (int y = 0; y < passable.height(); ++y) {
    const auto from = passable.row_words(y);
    std::copy(from.begin(), from.end(), drawn.row_words(passable.height() - 1 - y).begin());
  }
  return drawn;
}

}  // namespace wend
