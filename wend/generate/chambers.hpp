#pragma once

// Chambers: a map cut into rows and columns of chambers by walls one cell thick, all closed at
// first. Mazes and rooms open some of the walls.

#include <vector>

#include "wend/base/random.hpp"
#include "wend/generate/block.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

class Chambers {
 public:
  /// Makes as many chambers of at least `chamber` x `chamber` cells as fit. If the size leaves a
  /// remainder, some are a little larger.
  Chambers(int width, int height, int chamber);

  int columns() const { return static_cast<int>(wall_columns_.size()) - 1; }
  int rows() const { return static_cast<int>(wall_rows_.size()) - 1; }

  /// The wall between two chambers, `b` right of or below `a`.
  Block wall_between(Cell a, Cell b) const;

  Grid<CellState>& cells() { return cells_; }

 private:
  std::vector<int> wall_columns_;
  std::vector<int> wall_rows_;
  Grid<CellState> cells_;
};

/// Pairs of neighbours (the second one right of or below the first) that join all cells of a
/// columns x rows grid into a tree, made by a random depth-first walk: long winding paths.
std::vector<std::pair<Cell, Cell>> random_spanning_tree(int columns, int rows, Random& random);

}  // namespace wend
