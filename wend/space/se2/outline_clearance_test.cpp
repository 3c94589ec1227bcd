#include "wend/space/se2/outline_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "wend/base/random.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// The least distance of points all over the polygon from the squares of obstacles.
double sampled_clearance(const FreeSpace& space, const Pose& pose) {
  constexpr int kSamples = 60;
  const auto [sine, cosine] = sine_and_cosine(pose.heading);
  double least = 1e9;
  for (int i = 0; i <= kSamples; ++i) {
    for (int k = 0; k <= kSamples; ++k) {
      const Point at{-1 + 4.0 * i / kSamples, -0.8 + 1.6 * k / kSamples};
      const Point p{pose.x + cosine * at.x - sine * at.y, pose.y + sine * at.x + cosine * at.y};
      least = std::min({least, p.x, p.y, space.width() - p.x, space.height() - p.y});
      for (const Cell cell : every_cell(space.map().occupied())) {
        if (!space.obstacles().blocked()[cell]) continue;
        const double dx = std::max({cell.x - p.x, p.x - cell.x - 1, 0.0});
        const double dy = std::max({cell.y - p.y, p.y - cell.y - 1, 0.0});
        least = std::min(least, std::hypot(dx, dy));
      }
    }
  }
  return least;
}

TEST(OutlineClearance, IsNeverMoreThanTheDistanceAndHardlyLess) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Grid<CellState> states(24, 20, CellState::free);
    for (int i = 0; i < 6; ++i) {
      states[{random.between(0, 23), random.between(0, 19)}] = CellState::occupied;
    }
    const FreeSpace space = *make_free_space(
        *make_grid_map(states), {.footprint = *parse_footprint("3,0.8;-1,0.8;-1,-0.8;3,-0.8"),
                                 .outside = OutsidePolicy::blocked});
    const OutlineClearance clearance(space, *space.outline());
    ASSERT_FALSE(clearance.empty());
    const Pose pose{24 * random.uniform(), 20 * random.uniform(), 2 * kPi * random.uniform()};
    if (!space.fits(pose)) continue;
    ++compared;
    constexpr double kMost = 5;
    constexpr double kBetweenSamples = 0.05;
    const double exact = std::min(kMost, sampled_clearance(space, pose));
    const double found = clearance.at(space, pose, kMost);
    EXPECT_LE(found, exact + 1e-9);
    // Near a corner of the polygon it takes the distance from the lines through the edges.
    const double rounding = exact < 1 ? 1e-9 : 1.5;
    EXPECT_GE(found, (exact - kBetweenSamples) / std::sqrt(2.0) - rounding);
  }
  EXPECT_GT(compared, 20);
}

}  // namespace
}  // namespace wend
