#pragma once

// Block: a rectangle of cells, the drawing primitive of generators.

#include <algorithm>

#include "wend/map/grid.hpp"

namespace wend {

/// Cells [x, x + width) x [y, y + height).
struct Block {
  int x;
  int y;
  int width;
  int height;

  int x_end() const { return x + width; }
  int y_end() const { return y + height; }

  Block grown(int by) const { return {x - by, y - by, width + 2 * by, height + 2 * by}; }
};

/// The size of part i if `total` is divided into `parts` about equal parts.
inline int part(int i, int parts, int total) { return (i + 1) * total / parts - i * total / parts; }

/// The part of a block that lies on a grid.
template <class T>
Block clipped(const Grid<T>& grid, const Block& block) {
  const int x = std::max(block.x, 0);
  const int y = std::max(block.y, 0);
  return {x, y, std::max(0, std::min(block.x_end(), grid.width()) - x),
          std::max(0, std::min(block.y_end(), grid.height()) - y)};
}

/// Sets the cells of a block that lie on the grid.
template <class T>
void fill(Grid<T>& grid, const Block& block, T value) {
  const Block on_grid = clipped(grid, block);
  for (int y = on_grid.y; y < on_grid.y_end(); ++y) {
    const auto cells = grid.row(y).subspan(static_cast<std::size_t>(on_grid.x),
                                           static_cast<std::size_t>(on_grid.width));
    std::fill(cells.begin(), cells.end(), value);
  }
}

/// Does the block lie on the grid, and are all its cells equal to `value`?
template <class T>
bool all_equal(const Grid<T>& grid, const Block& block, T value) {
  const Block on_grid = clipped(grid, block);
  if (on_grid.width != block.width || on_grid.height != block.height) return false;
  for (int y = block.y; y < block.y_end(); ++y) {
    const auto cells = grid.row(y).subspan(static_cast<std::size_t>(block.x),
                                           static_cast<std::size_t>(block.width));
    if (std::any_of(cells.begin(), cells.end(), [&](T cell) { return cell != value; })) {
      return false;
    }
  }
  return true;
}

}  // namespace wend
