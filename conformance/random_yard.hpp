#pragma once

// Random yards for a car, and cars for them: more room than on random maps, rougher ground.

#include <array>
#include <cmath>
#include <numbers>

#include "conformance/random_map.hpp"

namespace wend::test {

/// Of whole numbers, small or large, or of any; empty for uniform terrain.
inline Grid<double> random_rough(Random& random, int width, int height) {
  enum class Kind { uniform, small, large, any };
  const Kind kind = one_of<Kind>(random, std::array{Kind::uniform, Kind::uniform, Kind::small,
                                                    Kind::small, Kind::large, Kind::any});
  if (kind == Kind::uniform) return {};
  const double share = random.uniform();
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!random.chance(share)) continue;
      terrain[{x, y}] = kind == Kind::small   ? random.between(1, 5)
                        : kind == Kind::large ? random.between(1, 20)
                                              : 1 + 3 * random.uniform();
    }
  }
  return terrain;
}

/// As random_map(), with fewer obstacles: each makes four corners impassable.
inline GridMap random_yard(Random& random, int width, int height) {
  const GridMap map = random_map(random, width, height);
  const auto kept = one_of<double>(random, std::array{0.0, 0.1, 0.3, 0.3, 0.6, 1.0});
  Grid<CellState> states(width, height, CellState::free);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(kept)) states[{x, y}] = map.state({x, y});
    }
  }
  return *make_grid_map(states, map.frame(), random_rough(random, width, height));
}

inline GridMap random_yard(Random& random) {
  const int most = one_of<int>(random, std::array{1, 3, 6, 6, 9, 9, 9, 9, 16});
  return random_yard(random, random.between(1, most), random.between(1, most));
}

/// Mostly a point, else a disc: radii at which it touches a square from an arc are among them.
inline FreeSpaceOptions random_car(Random& random, double resolution, int unit) {
  const auto radius = one_of<double>(
      random, std::array{0.0, 0.0, 0.0, 0.0, 0.1, 0.41, std::numbers::sqrt2 - 1, 0.42, 0.5,
                         std::sqrt(0.5), 0.99, 1.0, 1.01, std::numbers::sqrt2, 1.5});
  FreeSpaceOptions options = random_robot(random, resolution);
  options.footprint = Footprint::disc(radius * resolution * (random.chance(0.7) ? unit : 1));
  return options;
}

}  // namespace wend::test
