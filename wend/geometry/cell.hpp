#pragma once

// Cell: one square of a grid.
//
// Grid coordinates: one unit is one cell. Cell (x, y) covers [x, x+1) x [y, y+1), its centre is
// (x+0.5, y+0.5); corner (x, y) is the point (x, y).

#include <compare>
#include <cstdint>

namespace wend {

struct Cell {
  int x = 0;  // column
  int y = 0;  // row

  friend constexpr bool operator==(const Cell&, const Cell&) = default;
  friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
};

}  // namespace wend
