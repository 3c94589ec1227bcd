#pragma once

// Distances on small boards by brute force, for the tests of this folder. Shares no code with what
// it checks.

#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend::test {

inline constexpr std::uint64_t kUnreached = std::numeric_limits<std::uint64_t>::max();

inline bool brute_step_is_legal(const BitGrid& passable, Cell from, int dx, int dy) {
  const auto free = [&](int x, int y) { return passable.contains({x, y}) && passable[{x, y}]; };
  return free(from.x + dx, from.y + dy) && free(from.x + dx, from.y) && free(from.x, from.y + dy);
}

/// From one cell to all, without cutting corners; a straight step costs 33461, a diagonal step 47321.
inline Grid<std::uint64_t> brute_distances(const BitGrid& passable, Cell from) {
  Grid<std::uint64_t> distances(passable.width(), passable.height(), kUnreached);
  using Entry = std::pair<std::uint64_t, Cell>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distances[from] = 0;
  queue.push({0, from});
  while (!queue.empty()) {
    const auto [distance, cell] = queue.top();
    queue.pop();
    if (distance > distances[cell]) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || !brute_step_is_legal(passable, cell, dx, dy)) continue;
        const Cell next{cell.x + dx, cell.y + dy};
        const std::uint64_t longer = distance + (dx != 0 && dy != 0 ? 47321 : 33461);
        if (longer >= distances[next]) continue;
        distances[next] = longer;
        queue.push({longer, next});
      }
    }
  }
  return distances;
}

/// Is the path that goes diagonally first, then straight, free?
inline bool brute_sees(const BitGrid& passable, Cell from, Cell to) {
  while (from != to) {
    const int dx = (to.x > from.x) - (to.x < from.x);
    const int dy = (to.y > from.y) - (to.y < from.y);
    if (!brute_step_is_legal(passable, from, dx, dy)) return false;
    from = {from.x + dx, from.y + dy};
  }
  return true;
}

/// One line of text per row of the board.
inline std::string text_of(const BitGrid& bits) {
  std::string text;
  for (int y = 0; y < bits.height(); ++y) {
    for (int x = 0; x < bits.width(); ++x) text += bits[{x, y}] ? '.' : '#';
    text += '\n';
  }
  return text;
}

inline std::vector<Cell> passable_cells(const BitGrid& bits) {
  std::vector<Cell> cells;
  for (int y = 0; y < bits.height(); ++y) {
    for (int x = 0; x < bits.width(); ++x) {
      if (bits[{x, y}]) cells.push_back({x, y});
    }
  }
  return cells;
}

/// Calls check(bits) for boards of many shapes and densities, including all boards of 3 x 3 cells.
template <class Check>
void for_small_boards(int random_boards, Check&& check) {
  for (unsigned pattern = 0; pattern < 512; ++pattern) {
    BitGrid bits(3, 3);
    for (int i = 0; i < 9; ++i) bits.set({i % 3, i / 3}, (pattern >> i & 1U) != 0);
    check(bits);
  }
  for (int seed = 1; seed <= test::share_of(random_boards); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const int width = random.chance(0.1) ? random.between(60, 70) : random.between(1, 16);
    const int height = width > 16 ? random.between(1, 4) : random.between(1, 16);
    const bool flip = random.chance(0.5);
    BitGrid bits(flip ? height : width, flip ? width : height);
    const double density = random.uniform();
    for (int y = 0; y < bits.height(); ++y) {
      for (int x = 0; x < bits.width(); ++x) bits.set({x, y}, random.chance(density));
    }
    check(bits);
  }
}

}  // namespace wend::test
