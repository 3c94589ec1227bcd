#include "wend/robot/sweep/disc_rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "conformance/random_map.hpp"
#include "wend/geometry/line.hpp"
#include "wend/robot/sweep/disc_sweep.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

constexpr int kLines = 40;  // on each map

/// Half of them are whole half cells, so that lines touch obstacles.
double draw_radius(Random& random) {
  return random.between(0, 1) == 0 ? random.between(1, 9) / 2.0 : random.between(1, 500) / 100.0;
}

/// Some of them lie a little off the map.
Point draw_point(Random& random, const FreeSpace& space, int per_cell) {
  const auto draw = [&](int cells) {
    return static_cast<double>(random.between(-per_cell, per_cell * (cells + 1))) / per_cell;
  };
  return {draw(space.width()), draw(space.height())};
}

double distance_to_obstacles(const FreeSpace& space, const Line& line) {
  double least = std::numeric_limits<double>::infinity();
  if (space.outside() == OutsidePolicy::blocked) least = edge_clearance(space, line);
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      const Cell square{x, y};
      if (space.obstacles().blocked()[square]) least = std::min(least, distance(line, square));
    }
  }
  return least;
}

RC_GTEST_PROP(DiscRows, AgreeWithTheDistanceToEveryObstacle, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const GridMap map = test::random_map(random, random.between(1, 80), random.between(1, 20));
  const double radius = draw_radius(random);
  const FreeSpace space = *make_free_space(
      map, {.footprint = Footprint::disc(radius * map.frame().resolution),
            .outside = random.between(0, 1) == 0 ? OutsidePolicy::free : OutsidePolicy::blocked});
  const int per_cell = random.between(0, 2) == 0 ? 100 : 2;
  for (int i = 0; i < kLines; ++i) {
    Line line{draw_point(random, space, per_cell), draw_point(random, space, per_cell)};
    if (random.between(0, 3) == 0) line.to.y = line.from.y;
    if (random.between(0, 3) == 0) line.to.x = line.from.x;
    const bool fits = disc_fits_along(space, line);
    constexpr double kRounding = 1e-7;
    const double spare = distance_to_obstacles(space, line) - radius;
    if (spare > kRounding) RC_ASSERT(fits);
    if (spare < -kRounding) RC_ASSERT(!fits);
    const DiscSweep sweep(space);
    if (sweep.fits_at(line.from) && sweep.fits_at(line.to)) RC_ASSERT(fits == sweep.fits(line));
  }
}

}  // namespace
}  // namespace wend
