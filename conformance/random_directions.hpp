#pragma once

// Random directions for a map: arrows of every heading and strictness in rectangles that may overlap, and hills.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "wend/base/random.hpp"
#include "wend/map/direction_map.hpp"

namespace wend::test {

inline ArrowOptions random_arrow(Random& random) {
  constexpr double kEighth = std::numbers::pi / 4;
  const std::array tolerances{0.0, kEighth, 2 * kEighth, 3 * kEighth,
                              std::numbers::pi * random.uniform()};
  ArrowOptions options{.tolerance = tolerances[static_cast<std::size_t>(random.between(0, 4))]};
  if (random.chance(0.4)) options.factor = 1 + 4 * random.uniform();
  return options;
}

/// Along an axis, along a diagonal or between.
inline double random_arrow_heading(Random& random) {
  constexpr double kEighth = std::numbers::pi / 4;
  if (random.chance(0.3)) return 2 * std::numbers::pi * random.uniform();
  return kEighth * random.between(0, 7);
}

inline GridMap with_random_arrows(Random& random, const GridMap& map) {
  Grid<double> headings(map.width(), map.height(), std::numeric_limits<double>::quiet_NaN());
  for (int zones = random.between(1, 4); zones > 0; --zones) {
    const Cell first{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
    const Cell last{random.between(first.x, map.width() - 1),
                    random.between(first.y, map.height() - 1)};
    const double heading = random_arrow_heading(random);
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) headings[{x, y}] = heading;
    }
  }
  return *with_arrows(map, headings, random_arrow(random));
}

inline GridMap with_random_hills(Random& random, const GridMap& map) {
  Grid<double> heights(map.width(), map.height(), 0);
  const double size = map.frame().resolution;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) heights[{x, y}] = size * random.between(0, 3) / 2;
  }
  return *with_heights(map, heights,
                       {.climb = 4 * random.uniform(), .descend = 2 * random.uniform()});
}

/// The map with one to three layers of directions.
inline GridMap with_random_directions(Random& random, GridMap map) {
  for (int layers = random.between(1, 2); layers > 0; --layers) {
    map = with_random_arrows(random, map);
  }
  return random.chance(0.3) ? with_random_hills(random, map) : map;
}

}  // namespace wend::test
