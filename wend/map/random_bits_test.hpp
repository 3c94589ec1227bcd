#pragma once

// Bit grids of many shapes and densities for the tests of this folder.

#include <iterator>
#include <utility>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend::test {

inline BitGrid random_bits(Random& random, int width, int height, double density) {
  BitGrid bits(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) bits.set({x, y}, random.chance(density));
  }
  return bits;
}

/// Odd shapes (rows, columns, around a word's width), some empty, full, or with a single bit.
inline BitGrid random_odd_bits(Random& random) {
  constexpr int kWidths[] = {1, 2, 3, 5, 8, 13, 30, 61, 62, 63, 64, 65, 66, 126, 127, 130};
  int width = kWidths[random.below(std::size(kWidths))];
  int height = 1 + static_cast<int>(random.below(width > 30 ? 12 : 40));
  if (random.chance(0.2)) std::swap(width, height);
  if (random.chance(0.1)) height = 1;
  switch (random.below(8)) {
    case 0:
      return random_bits(random, width, height, random.chance(0.5) ? 1 : 0);
    case 1: {
      BitGrid bits(width, height);
      bits.set({random.between(0, width - 1), random.between(0, height - 1)}, true);
      return bits;
    }
    case 2:
      return random_bits(random, width, height, 0.01);
    default:
      return random_bits(random, width, height, random.uniform());
  }
}

inline std::vector<Cell> all_cells(int width, int height) {
  std::vector<Cell> cells;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.push_back({x, y});
  }
  return cells;
}

}  // namespace wend::test
