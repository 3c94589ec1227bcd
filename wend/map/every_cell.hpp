#pragma once

// The cells of a map one after the other, row by row.
//
//   for (const wend::Cell cell : wend::every_cell(grid)) sum += grid[cell];

#include "wend/geometry/cell.hpp"

namespace wend {

/// Those of a rectangle.
class CellRange {
 public:
  struct Iterator {
    Cell cell;
    int width;

    Cell operator*() const { return cell; }
    Iterator& operator++() {
      if (++cell.x == width) cell = {0, cell.y + 1};
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };

  CellRange(int width, int height) : width_(width), height_(width > 0 ? height : 0) {}

  Iterator begin() const { return {{0, 0}, width_}; }
  Iterator end() const { return {{0, height_}, width_}; }

 private:
  int width_;
  int height_;
};

/// Of whatever has a width and a height.
template <class Layer>
CellRange every_cell(const Layer& layer) {
  return {layer.width(), layer.height()};
}

}  // namespace wend
