#pragma once

// Grid<T>: a value for every cell of a map, row by row. Cell (0, 0) comes first.

#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"

namespace wend {

template <class T>
class Grid {
  static_assert(!std::is_same_v<T, bool>, "use BitGrid for one bit a cell");

 public:
  /// No cells.
  Grid() = default;
  /// The same value in every cell.
  Grid(int width, int height, T value = T{})
      : width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

  /// Takes one value for each cell, row by row.
  Grid(int width, int height, std::vector<T> values)
      : width_(width), height_(height), values_(std::move(values)) {
    assert(values_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }

  /// The number of columns.
  int width() const { return width_; }
  /// The number of rows.
  int height() const { return height_; }
  /// The number of cells.
  std::size_t size() const { return values_.size(); }
  /// Are there no cells?
  bool empty() const { return values_.empty(); }

  /// Is the cell on the map?
  bool contains(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_;
  }

  /// The value of a cell, which must be on the map. O(1).
  T& operator[](Cell cell) { return values_[index(cell)]; }
  /// The value of a cell, which must be on the map. O(1).
  const T& operator[](Cell cell) const { return values_[index(cell)]; }

  /// The values of a row, from column 0 on. The grid must not be empty.
  std::span<T> row(int y) { return {values_.data() + index({0, y}), extent()}; }
  /// The values of a row, from column 0 on. The grid must not be empty.
  std::span<const T> row(int y) const { return {values_.data() + index({0, y}), extent()}; }

  /// All values, row by row.
  std::span<const T> values() const { return values_; }

  friend bool operator==(const Grid&, const Grid&) = default;

 private:
  std::size_t extent() const { return static_cast<std::size_t>(width_); }
  std::size_t index(Cell cell) const {
    assert(contains(cell));
    return static_cast<std::size_t>(cell.y) * extent() + static_cast<std::size_t>(cell.x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

}  // namespace wend
