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

/// The cells of a rectangle one after the other, row by row.
///
///   for (const wend::Cell cell : wend::every_cell(grid)) sum += grid[cell];
class CellRange {
 public:
  /// Goes through the cells row by row.
  struct Iterator {
    Cell cell;  // the current cell
    int width;  // of the rectangle

    /// The current cell.
    Cell operator*() const { return cell; }
    /// Goes to the next cell: in the row, or the first of the next row.
    Iterator& operator++() {
      if (++cell.x == width) cell = {0, cell.y + 1};
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };

  /// The cells (0, 0) to (width - 1, height - 1); none if a size is 0.
  CellRange(int width, int height) : width_(width), height_(width > 0 ? height : 0) {}

  /// At the cell (0, 0).
  Iterator begin() const { return {{0, 0}, width_}; }
  /// Behind the last cell.
  Iterator end() const { return {{0, height_}, width_}; }

 private:
  int width_;
  int height_;
};

/// The cells of a layer that has a width and a height.
template <class Layer>
CellRange every_cell(const Layer& layer) {
  return {layer.width(), layer.height()};
}

}  // namespace wend
