#include "lab/wasm/painting/pyramid.hpp"

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

/// What a level is made from: the map itself, or the level below.
struct Below {
  std::span<const std::uint8_t> obstacles;  // empty: those of the map
  std::span<const std::uint8_t> ground;
  int width;
  int height;

  unsigned obstacle(std::size_t at) const {
    if (!obstacles.empty()) return obstacles[at];
    return ground[at] == kObstacle ? 255 : 0;
  }
};

Below below_of(const std::vector<Level>& levels, std::size_t level,
               std::span<const std::uint8_t> cells, int width, int height) {
  if (level == 0) return {{}, cells, width, height};
  const Level& below = levels[level - 1];
  return {below.obstacles, below.ground, below.width, below.height};
}

void merge_block(Level& level, const Below& below, std::size_t index, const Block& block) {
  unsigned sum = 0;
  std::uint8_t dearest = 0;
  bool known = false;
  for (int i = 0; i < block.count; ++i) {
    const std::size_t at = block.at[static_cast<std::size_t>(i)];
    sum += below.obstacle(at);
    const std::uint8_t here = below.ground[at];
    if (here == kUnknownCell && !known) dearest = here;
    if (here != kUnknownCell && here != 0) {
      dearest = known ? std::max(dearest, here) : here;
      known = true;
    }
  }
  const unsigned mean = sum / static_cast<unsigned>(block.count);
  level.obstacles[index] = static_cast<std::uint8_t>(sum > 0 ? std::max(mean, 1U) : 0);
  level.ground[index] = dearest;
}

void find_least(const Level& level, const std::vector<std::uint32_t>& below, int width, int height,
                std::vector<std::uint32_t>& least) {
  least.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
  for_blocks(level, width, height, [&](std::size_t index, const Block& block) {
    std::uint32_t found = 0;
    for (int i = 0; i < block.count; ++i) {
      const std::uint32_t step = below[block.at[static_cast<std::size_t>(i)]];
      // 0 is never: as an unsigned number minus 1 it is the largest.
      if (step - 1 < found - 1) found = step;
    }
    least[index] = found;
  });
}

}  // namespace

void Pyramid::set_map(std::span<const std::uint8_t> cells, int width, int height) {
  levels_.clear();
  with_steps_ = 0;
  for (int x = width, y = height; x > 1 || y > 1;
       x = levels_.back().width, y = levels_.back().height) {
    levels_.push_back(half_of(x, y));
  }
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    Level& level = levels_[i];
    const auto size =
        static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
    level.obstacles.resize(size);
    level.ground.resize(size);
    const Below below = below_of(levels_, i, cells, width, height);
    for_blocks(level, below.width, below.height, [&](std::size_t index, const Block& block) {
      merge_block(level, below, index, block);
    });
  }
}

void Pyramid::update(std::span<const std::uint8_t> cells, int width, int height,
                     std::vector<std::uint32_t> changed) {
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    Level& level = levels_[i];
    const Below below = below_of(levels_, i, cells, width, height);
    const auto row = static_cast<std::uint32_t>(below.width);
    for (std::uint32_t& index : changed) {
      const std::uint32_t x = index % row / 2;
      const std::uint32_t y = index / row / 2;
      index = y * static_cast<std::uint32_t>(level.width) + x;
    }
    std::ranges::sort(changed);
    const auto rest = std::ranges::unique(changed);
    changed.erase(rest.begin(), rest.end());
    for (const std::uint32_t index : changed) {
      const int x = static_cast<int>(index) % level.width;
      const int y = static_cast<int>(index) / level.width;
      merge_block(level, below, index, block_of(x, y, below.width, below.height));
    }
  }
}

void Pyramid::forget_steps() {
  for (Level& level : levels_) {
    level.expansion.clear();
    level.generation.clear();
  }
  with_steps_ = 0;
}

void Pyramid::take_steps(const Replay& replay, int level) {
  if (replay.width() == 0) return;
  for (; with_steps_ <= level; ++with_steps_) {
    Level& next = levels_[static_cast<std::size_t>(with_steps_)];
    const Level* const below = with_steps_ > 0 ? &next - 1 : nullptr;
    const int width = below != nullptr ? below->width : replay.width();
    const int height = below != nullptr ? below->height : replay.height();
    find_least(next, below != nullptr ? below->expansion : replay.expansion(), width, height,
               next.expansion);
    find_least(next, below != nullptr ? below->generation : replay.generation(), width, height,
               next.generation);
  }
}

int Pyramid::level_for(double cells) const {
  int level = -1;
  for (double side = 2; side <= cells && level + 1 < levels(); side *= 2) ++level;
  return level;
}

}  // namespace wend::lab
