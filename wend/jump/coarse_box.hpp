#pragma once

// CoarseBox: a box around some cells in four bytes, so that one subtraction tells whether a cell may
// be in it.
//
//   const wend::CoarseRaster raster(width, height);
//   wend::CoarseBox box;
//   box.include(raster.place({3, 4}));
//   if (box.may_hold(raster.place(cell))) ...
//
// Places are counted in pieces of the map, 127 at most either way, so a box may hold cells that
// nobody put in, and never misses one.

#include <algorithm>
#include <cstdint>

#include "wend/geometry/cell.hpp"

namespace wend {

/// Where a cell lies: x, y, and both from the other end, 7 bits in each byte.
class CoarsePlace {
 public:
  static constexpr int kLast = 126;

  CoarsePlace() = default;
  constexpr CoarsePlace(int x, int y)
      : bytes_(static_cast<std::uint32_t>(x | y << 8 | (kLast - x) << 16 | (kLast - y) << 24)) {}

 private:
  friend class CoarseBox;
  std::uint32_t bytes_ = 0;
};

class CoarseRaster {
 public:
  constexpr CoarseRaster(int width, int height) {
    while ((std::max(width, height) - 1) >> shift_ > CoarsePlace::kLast) ++shift_;
  }

  /// A cell outside counts as one at the edge.
  constexpr CoarsePlace place(Cell cell) const {
    return {std::clamp(cell.x >> shift_, 0, CoarsePlace::kLast),
            std::clamp(cell.y >> shift_, 0, CoarsePlace::kLast)};
  }

 private:
  int shift_ = 0;
};

/// Empty at first.
class CoarseBox {
 public:
  constexpr void include(CoarsePlace place) {
    std::uint32_t least = 0;
    for (unsigned bit = 0; bit < 32; bit += 8) {
      least |= std::min(least_ >> bit & 0x7FU, place.bytes_ >> bit & 0x7FU) << bit;
    }
    least_ = least;
  }

  /// Is no byte of the place less than the least? No byte borrows from the next: its highest bit is
  /// set before, and stays set if and only if it was not less.
  constexpr bool may_hold(CoarsePlace place) const {
    return (((place.bytes_ | kHighest) - least_) & kHighest) == kHighest;
  }

 private:
  static constexpr std::uint32_t kHighest = 0x80808080U;

  std::uint32_t least_ = 0x7F7F7F7FU;  // by byte; no place is as great everywhere
};

}  // namespace wend
