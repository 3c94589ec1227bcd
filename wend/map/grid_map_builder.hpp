#pragma once

// GridMapBuilder: a GridMap row by row, as loaders read files, in no more memory than the map takes.
//
//   wend::GridMapBuilder rows(3);
//   rows.append(std::array{CellState::free, CellState::occupied, CellState::free});
//   const wend::GridMap map = std::move(rows).finish();

#include <cstddef>
#include <span>
#include <vector>

#include "wend/map/grid_map.hpp"

namespace wend {

class GridMapBuilder {
 public:
  /// Rows of so many cells, at least 1.
  explicit GridMapBuilder(int width);

  /// Makes room for so many rows at once. Without it memory grows with the rows.
  void reserve(int height);

  /// The next row. `terrain` has a multiplier for each cell, finite and at least 1; empty: they
  /// are all 1.
  void append(std::span<const CellState> states, std::span<const double> terrain = {});

  int width() const { return occupied_.width(); }
  int height() const { return occupied_.height(); }

  /// The map of the rows, one or more. The first one is the map's top row as drawn: row 0 of a frame
  /// with y down, the last one of a frame with y up.
  GridMap finish(Frame frame = {}) &&;

 private:
  BitGrid occupied_;
  BitGrid unknown_;
  std::vector<double> terrain_;  // of all rows; empty while every cell costs 1
};

}  // namespace wend
