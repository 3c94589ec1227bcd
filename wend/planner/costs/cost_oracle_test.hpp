#pragma once

// Maps with costs of every kind, and a textbook Dijkstra in the whole numbers of CostUnits, for tests of what
// searches with costs.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/grid_moves.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend::test {

inline constexpr std::uint64_t kNoUnits = std::numeric_limits<std::uint64_t>::max();

/// The cost of a step by the definition of CostUnits, or where every cell costs the same in OctileUnits.
inline std::uint64_t step_units(const FreeSpace& space, Cell from, Cell to) {
  using Octile = OctileUnits<std::uint64_t>;
  const bool diagonal = from.x != to.x && from.y != to.y;
  if (space.uniform_terrain()) return diagonal ? Octile::kDiagonal : Octile::kStraight;
  const std::uint64_t sum = std::uint64_t{space.costs().steps(from)} + space.costs().steps(to);
  return sum * (diagonal ? 577 : 408);
}

inline std::uint64_t units_of(const FreeSpace& space, std::span<const Cell> path) {
  std::uint64_t sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += step_units(space, path[i - 1], path[i]);
  return sum;
}

inline bool is_legal(const FreeSpace& space, GridMoves moves, Cell from, Cell to) {
  if (from == to || !space.passable(to)) return false;
  if (from.x == to.x || from.y == to.y) return true;
  if (moves.connectivity == Connectivity::four) return false;
  const int blocked =
      (space.passable(Cell{from.x, to.y}) ? 0 : 1) + (space.passable(Cell{to.x, from.y}) ? 0 : 1);
  return blocked <= static_cast<int>(moves.corner_rule);
}

/// Textbook Dijkstra in whole numbers: the least units from a cell to each.
inline std::vector<std::uint64_t> units_from(const FreeSpace& space, GridMoves moves, Cell start) {
  const int width = space.width();
  const auto number = [width](Cell cell) {
    return static_cast<std::size_t>(cell.y * width + cell.x);
  };
  std::vector<std::uint64_t> least(space.map().size(), kNoUnits);
  using Open = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  least[number(start)] = 0;
  open.emplace(0, number(start));
  while (!open.empty()) {
    const auto [g, at] = open.top();
    open.pop();
    if (g > least[at]) continue;
    const Cell from{static_cast<int>(at) % width, static_cast<int>(at) / width};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell to{from.x + dx, from.y + dy};
        if (!is_legal(space, moves, from, to)) continue;
        const std::uint64_t units = g + step_units(space, from, to);
        if (units >= least[number(to)]) continue;
        least[number(to)] = units;
        open.emplace(units, number(to));
      }
    }
  }
  return least;
}

enum class Ground { inflated, whole, nearly_even, spiky, rectangles, vast };

inline double multiplier_on(Ground ground, Random& random) {
  switch (ground) {
    case Ground::whole:
      return random.between(1, 3);
    case Ground::nearly_even:
      return 1 + random.uniform() / 2;
    case Ground::spiky:
      return random.chance(0.1) ? 1 + 100 * random.uniform() : 1;
    case Ground::vast:
      return random.chance(0.1) ? 1 + 1e6 * random.uniform() : 1;
    case Ground::inflated:
    case Ground::rectangles:
      break;
  }
  return 1;
}

inline void add_rectangles(Grid<double>& terrain, Random& random) {
  for (int left = random.between(1, 8); left > 0; --left) {
    const int x = random.between(0, terrain.width() - 1);
    const int y = random.between(0, terrain.height() - 1);
    const int width = random.between(1, 12);
    const int height = random.between(1, 12);
    const int rise = random.between(0, 4);
    const double multiplier = 1 + rise * (random.chance(0.5) ? 1 : 0.1);
    for (int j = y; j < std::min(y + height, terrain.height()); ++j) {
      for (int i = x; i < std::min(x + width, terrain.width()); ++i) terrain[{i, j}] = multiplier;
    }
  }
}

/// Walls three cells apart, with gaps, now and then.
inline void add_rooms(Grid<CellState>& states, Random& random) {
  for (int y = 0; y < states.height(); ++y) {
    for (int x = 0; x < states.width(); ++x) {
      const bool wall = x % 4 == 3 || y % 4 == 3;
      if (wall && !random.chance(0.3)) states[{x, y}] = CellState::occupied;
    }
  }
}

inline FreeSpace random_cost_space(Random& random) {
  const int width = random.between(1, 40);
  const int height = random.between(1, 40);
  const auto ground = static_cast<Ground>(random.between(0, 5));
  const double blocked = random.chance(0.3) ? 0.02 : 0.35 * random.uniform();
  Grid<CellState> states(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  for (const Cell cell : every_cell(terrain)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
    terrain[cell] = multiplier_on(ground, random);
  }
  if (random.chance(0.2)) add_rooms(states, random);
  if (ground == Ground::rectangles) add_rectangles(terrain, random);
  FreeSpaceOptions options;
  if (ground == Ground::inflated) {
    options.clearance_distance = 5 * random.uniform();
    options.clearance_cost = random.chance(0.5) ? 4 : 30 * random.uniform();
  }
  return *make_free_space(*make_grid_map(states, {}, terrain), options);
}

inline Cell random_cell_of(const FreeSpace& space, Random& random) {
  const int x = random.between(0, space.width() - 1);
  const int y = random.between(0, space.height() - 1);
  return {x, y};
}

}  // namespace wend::test
