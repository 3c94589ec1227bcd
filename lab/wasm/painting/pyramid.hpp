#pragma once

// Pyramid: a map at half, a quarter, ... of its size, for pictures that show several cells a pixel. Each level
// keeps how many cells of a block are obstacles, the least step of expansion and of generation in it, and its
// dearest ground. So nothing vanishes, however far one looks from.

#include <cstdint>
#include <span>
#include <vector>

#include "lab/wasm/painting/replay.hpp"

namespace wend::lab {

struct Level {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t>
      obstacles;  // 255: all cells of the block; 0: none; at least 1 if there is one
  std::vector<std::uint8_t> ground;       // the dearest free cell; 255 if all are unknown; 0: none
  std::vector<std::uint32_t> expansion;   // the least, 0: none
  std::vector<std::uint32_t> generation;  // the least, 0: none
};

class Pyramid {
 public:
  /// Makes the levels of a map. O(cells).
  void set_map(std::span<const std::uint8_t> cells, int width, int height);
  /// Takes over cells of a map of the same size that have changed, by their indices. O(log(cells)) each.
  void update(std::span<const std::uint8_t> cells, int width, int height,
              std::vector<std::uint32_t> changed);
  /// Forgets the steps of a search. O(levels).
  void forget_steps();
  /// Takes over the steps of a search on this map up to a level, as far as they are not there. O(cells).
  void take_steps(const Replay& replay, int level);

  /// The level for pictures with this number of cells a pixel; -1: the cells themselves.
  int level_for(double cells) const;

  /// The level with blocks of 2^(i + 1) x 2^(i + 1) cells, from 0.
  const Level& level(int i) const { return levels_[static_cast<std::size_t>(i)]; }
  int levels() const { return static_cast<int>(levels_.size()); }

 private:
  std::vector<Level> levels_;
  int with_steps_ = 0;  // levels that have the steps of the search
};

}  // namespace wend::lab
