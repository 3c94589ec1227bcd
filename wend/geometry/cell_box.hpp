#pragma once

// CellBox: a rectangle of cells, from its least cell to behind its greatest one.
//
//   const wend::CellBox edited{{3, 4}, {5, 6}};  // four cells
//   const wend::CellBox reached = edited.grown_by(10).clipped_to(map);

#include <algorithm>
#include <cstdint>

#include "wend/geometry/cell.hpp"

namespace wend {

struct CellBox {
  Cell begin = {};  // the least column and row
  Cell end = {};    // the column and row behind the greatest

  /// All cells of a layer that has a width and a height.
  template <class Layer>
  static CellBox of(const Layer& layer) {
    return {{0, 0}, {layer.width(), layer.height()}};
  }

  /// The number of columns; not above 0 in an empty box.
  constexpr int width() const { return end.x - begin.x; }
  /// The number of rows; not above 0 in an empty box.
  constexpr int height() const { return end.y - begin.y; }
  /// Has it no cells?
  constexpr bool empty() const { return width() <= 0 || height() <= 0; }
  /// The number of cells.
  constexpr std::int64_t size() const {
    return empty() ? 0 : std::int64_t{width()} * std::int64_t{height()};
  }

  /// Does the cell lie in the box?
  constexpr bool contains(Cell cell) const {
    return cell.x >= begin.x && cell.y >= begin.y && cell.x < end.x && cell.y < end.y;
  }

  /// The box and `cells` more cells on each side. Of a box that is not empty.
  constexpr CellBox grown_by(int cells) const {
    return {{begin.x - cells, begin.y - cells}, {end.x + cells, end.y + cells}};
  }

  /// The cells that lie in both; empty if there are none.
  constexpr CellBox common_with(const CellBox& other) const {
    return {{std::max(begin.x, other.begin.x), std::max(begin.y, other.begin.y)},
            {std::min(end.x, other.end.x), std::min(end.y, other.end.y)}};
  }

  /// The part on a layer that has a width and a height.
  template <class Layer>
  CellBox clipped_to(const Layer& layer) const {
    return common_with(of(layer));
  }

  /// The least box that contains both.
  constexpr CellBox joined_with(const CellBox& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {{std::min(begin.x, other.begin.x), std::min(begin.y, other.begin.y)},
            {std::max(end.x, other.end.x), std::max(end.y, other.end.y)}};
  }

  friend constexpr bool operator==(const CellBox&, const CellBox&) = default;
};

}  // namespace wend
