#pragma once

// random_cells(): a small map of free cells for properties of sight and of paths at any angle.

#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend::test {

/// A map of 1 to `longest` cells a side; a share of them, `least_share` to 1, is set.
inline BitGrid random_cells(Random& random, int longest, double least_share) {
  const int width = random.between(1, longest);
  const int height = random.between(1, longest);
  BitGrid cells(width, height);
  const double share = least_share + (1 - least_share) * random.uniform();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_set = random.chance(share);
      cells.set({x, y}, is_set);
    }
  }
  return cells;
}

}  // namespace wend::test
