#pragma once

// Asks the obstacles near something, a word of 64 cells at a time.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "wend/geometry/pose.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

/// The cell of the map that is nearest to a point.
inline Cell nearest_cell(const FreeSpace& space, Point point) {
  return {static_cast<int>(std::clamp(std::floor(point.x), 0.0, space.width() - 1.0)),
          static_cast<int>(std::clamp(std::floor(point.y), 0.0, space.height() - 1.0))};
}

/// Upright, closed, in grid coordinates.
struct Box {
  Point low;
  Point high;

  explicit Box(Point point) : low(point), high(point) {}

  void include(Point point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }

  Box grown_by(double margin) const {
    Box box({low.x - margin, low.y - margin});
    box.include({high.x + margin, high.y + margin});
    return box;
  }
};

/// Is there an obstacle of which this holds? All that reach into the box are asked, row by row, and
/// perhaps others on the map's border.
template <class Predicate>
bool any_obstacle(const FreeSpace& space, const Box& box, Predicate&& predicate) {
  const Cell first = nearest_cell(space, box.low);
  const Cell last = nearest_cell(space, box.high);
  for (int y = first.y; y <= last.y; ++y) {
    const auto words = space.obstacles().row_words(y);
    const auto begin = static_cast<std::size_t>(first.x) + 1;  // the bit of cell x is x + 1
    const auto end = static_cast<std::size_t>(last.x) + 2;
    for (std::size_t i = begin / 64; 64 * i < end; ++i) {
      std::uint64_t bits = words[i];
      if (64 * i < begin) bits &= ~std::uint64_t{0} << (begin % 64);
      if (64 * i + 64 > end) bits &= ~(~std::uint64_t{0} << (end % 64));
      for (; bits != 0; bits &= bits - 1) {
        const auto x = static_cast<int>(64 * i) + std::countr_zero(bits) - 1;
        if (predicate(Cell{x, y})) return true;
      }
    }
  }
  return false;
}

}  // namespace wend
