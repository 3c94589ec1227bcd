#pragma once

// Walks along a diagonal, step by step, without cutting corners.

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

/// Visits the cells after `from` until a step is not legal or `visit(cell)` says false.
template <class Visit>
void walk_diagonal(const BitGrid& passable, Cell from, Direction diagonal, Visit&& visit) {
  for (Cell cell = from;;) {
    const Cell next = step(cell, diagonal);
    if (!passable[{next.x, cell.y}] || !passable[{cell.x, next.y}] || !passable[next]) return;
    if (!visit(next)) return;
    cell = next;
  }
}

}  // namespace wend
