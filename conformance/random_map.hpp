#pragma once

// Random maps, robots and cells for tests: small ones of every shape, free, full and in between,
// with and without unknown cells and terrain, with y up and down.

#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "wend/base/random.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

template <class T, std::size_t kCount>
T one_of(Random& random, const std::array<T, kCount>& values) {
  return values[random.below(kCount)];
}

/// The same cells in another frame.
inline GridMap in_frame(const GridMap& map, const Frame& frame) {
  return *make_grid_map(map.occupied(), map.unknown(), frame, map.terrain());
}

inline Cell random_cell(Random& random, int width, int height) {
  return {random.between(0, width - 1), random.between(0, height - 1)};
}

/// A cell that is sometimes a little outside of the map.
inline Cell random_cell_or_outside(Random& random, int width, int height) {
  Cell cell = random_cell(random, width, height);
  if (random.chance(0.02)) cell.x = random.chance(0.5) ? -1 : width;
  if (random.chance(0.02)) cell.y = random.chance(0.5) ? -1 : height;
  return cell;
}

inline Grid<CellState> random_states(Random& random, int width, int height) {
  const auto blocked = one_of<double>(random, std::array{0.0, 0.1, 0.25, 0.4, 0.5, 1.0});
  const auto unknown = one_of<double>(random, std::array{0.0, 0.0, 0.1, 0.5});
  Grid<CellState> states(width, height, CellState::free);
  const auto block = [&](Cell cell) {
    states[cell] = random.chance(unknown) ? CellState::unknown : CellState::occupied;
  };
  if (random.chance(0.7)) {  // single cells
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (random.chance(blocked)) block({x, y});
      }
    }
  } else {  // walls with a few gaps
    for (int wall = random.between(1, 6); wall > 0; --wall) {
      const Cell at = random_cell(random, width, height);
      const bool upright = random.chance(0.5);
      for (int i = 0; i < (upright ? height : width); ++i) {
        if (!random.chance(0.1)) block(upright ? Cell{at.x, i} : Cell{i, at.y});
      }
    }
  }
  return states;
}

/// Empty for uniform terrain.
inline Grid<double> random_terrain(Random& random, int width, int height) {
  if (random.chance(0.6)) return {};
  const bool whole_numbers = random.chance(0.5);
  const double rough = random.uniform();
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!random.chance(rough)) continue;
      terrain[{x, y}] = whole_numbers ? random.between(1, 9) : 1 + 4 * random.uniform();
    }
  }
  return terrain;
}

inline GridMap random_map(Random& random, int width, int height) {
  Frame frame;
  frame.resolution = one_of<double>(random, std::array{1.0, 1.0, 0.1, 0.05});
  frame.y_up = random.chance(0.5);
  frame.metric = random.chance(0.3);
  frame.origin = {random.uniform(), random.uniform(), 0};
  const Grid<CellState> states = random_states(random, width, height);
  return *make_grid_map(states, frame, random_terrain(random, width, height));
}

/// Many small maps, some of one row, column or cell, a few larger ones.
inline GridMap random_map(Random& random) {
  const int most = one_of<int>(random, std::array{1, 3, 6, 6, 12, 12, 12, 40});
  const bool line = random.chance(0.1);
  const int width = random.between(1, most);
  const int height = line ? 1 : random.between(1, most);
  return random.chance(0.5) ? random_map(random, width, height) : random_map(random, height, width);
}

inline std::optional<OutsidePolicy> random_outside(Random& random) {
  return one_of<std::optional<OutsidePolicy>>(
      random, std::array<std::optional<OutsidePolicy>, 3>{std::nullopt, OutsidePolicy::blocked,
                                                          OutsidePolicy::free});
}

/// Mostly a point, else a disc; radii that touch squares exactly are among them. Some keep away.
inline FreeSpaceOptions random_robot(Random& random, double resolution) {
  const auto radius = one_of<double>(
      random, std::array{0.0, 0.0, 0.0, 0.0, 0.1, 0.5, std::sqrt(0.5), 1.0, 1.5, 2.0, 3.3});
  const auto clearance_distance =
      one_of<double>(random, std::array{0.0, 0.0, 0.0, 0.4, 0.5, 1.0, 2.5, 7.0});
  return {.footprint = Footprint::disc(radius * resolution),
          .unknown = random.chance(0.5) ? UnknownPolicy::blocked : UnknownPolicy::free,
          .outside = random_outside(random),
          .clearance_distance = clearance_distance * resolution,
          .clearance_cost = one_of<double>(random, std::array{0.0, 0.5, 4.0, 4.0, 100.0})};
}

/// The map as text, the top row as drawn first, for messages.
inline std::string drawing_of(const GridMap& map) {
  std::ostringstream text;
  for (int row = 0; row < map.height(); ++row) {
    const int y = map.frame().y_up ? map.height() - 1 - row : row;
    for (int x = 0; x < map.width(); ++x) {
      const CellState state = map.state({x, y});
      text << (state == CellState::free ? '.' : state == CellState::occupied ? '#' : '?');
    }
    text << '\n';
  }
  return text.str();
}

}  // namespace wend::test
