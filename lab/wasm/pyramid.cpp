#include "lab/wasm/pyramid.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "lab/wasm/cells.hpp"

namespace wend::lab {
namespace {

/// The indices of the up to four values that a block of the next level covers.
struct Block {
  std::array<std::size_t, 4> at;
  int count;
};

Block block_of(int x, int y, int width, int height) {
  Block block{{}, 0};
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      if (2 * x + dx >= width || 2 * y + dy >= height) continue;
      block.at[static_cast<std::size_t>(block.count++)] =
          static_cast<std::size_t>(2 * y + dy) * static_cast<std::size_t>(width) +
          static_cast<std::size_t>(2 * x + dx);
    }
  }
  return block;
}

Level half_of(int width, int height) {
  Level half;
  half.width = (width + 1) / 2;
  half.height = (height + 1) / 2;
  return half;
}

/// Calls `merge(index of the block, block)` for all blocks of a level above one of this size.
template <class Merge>
void for_blocks(const Level& level, int width, int height, Merge&& merge) {
  std::size_t index = 0;
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) merge(index++, block_of(x, y, width, height));
  }
}

void merge_map(Level& level, std::span<const std::uint8_t> obstacles,
               std::span<const std::uint8_t> ground, int width, int height) {
  const auto size = static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
  level.obstacles.resize(size);
  level.ground.resize(size);
  for_blocks(level, width, height, [&](std::size_t index, const Block& block) {
    unsigned sum = 0;
    std::uint8_t dearest = 0;
    bool known = false;
    for (int i = 0; i < block.count; ++i) {
      const std::size_t at = block.at[static_cast<std::size_t>(i)];
      sum += obstacles[at];
      const std::uint8_t here = ground[at];
      if (here == kUnknownCell && !known) dearest = here;
      if (here != kUnknownCell && here != 0) {
        dearest = known ? std::max(dearest, here) : here;
        known = true;
      }
    }
    const unsigned mean = sum / static_cast<unsigned>(block.count);
    level.obstacles[index] = static_cast<std::uint8_t>(sum > 0 ? std::max(mean, 1U) : 0);
    level.ground[index] = dearest;
  });
}

std::vector<std::uint32_t> least_of(const Level& level, const std::vector<std::uint32_t>& below,
                                    int width, int height) {
  std::vector<std::uint32_t> least(static_cast<std::size_t>(level.width) *
                                   static_cast<std::size_t>(level.height));
  for_blocks(level, width, height, [&](std::size_t index, const Block& block) {
    std::uint32_t found = 0;
    for (int i = 0; i < block.count; ++i) {
      const std::uint32_t step = below[block.at[static_cast<std::size_t>(i)]];
      // 0 is never: as an unsigned number minus 1 it is the largest.
      if (step - 1 < found - 1) found = step;
    }
    least[index] = found;
  });
  return least;
}

}  // namespace

void Pyramid::set_map(std::span<const std::uint8_t> cells, int width, int height) {
  levels_.clear();
  std::vector<std::uint8_t> obstacles(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) obstacles[i] = cells[i] == kObstacle ? 255 : 0;
  const std::vector<std::uint8_t> ground(cells.begin(), cells.end());
  while (width > 1 || height > 1) {
    Level next = half_of(width, height);
    if (levels_.empty()) {
      merge_map(next, obstacles, ground, width, height);
    } else {
      merge_map(next, levels_.back().obstacles, levels_.back().ground, width, height);
    }
    width = next.width;
    height = next.height;
    levels_.push_back(std::move(next));
  }
}

void Pyramid::set_replay(const Replay& replay) {
  if (replay.width() == 0) {
    for (Level& level : levels_) {
      level.expansion.clear();
      level.generation.clear();
    }
    return;
  }
  int width = replay.width();
  int height = replay.height();
  const std::vector<std::uint32_t>* expansion = &replay.expansion();
  const std::vector<std::uint32_t>* generation = &replay.generation();
  for (Level& level : levels_) {
    level.expansion = least_of(level, *expansion, width, height);
    level.generation = least_of(level, *generation, width, height);
    width = level.width;
    height = level.height;
    expansion = &level.expansion;
    generation = &level.generation;
  }
}

}  // namespace wend::lab
