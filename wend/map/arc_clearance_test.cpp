#include "wend/map/arc_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/testing/blocked_squares.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_arc.hpp"
#include "tests/testing/random_map.hpp"
#include "wend/geometry/arc_distance.hpp"

namespace wend {
namespace {

/// The least over all squares that count.
double brute_force(const FreeSpace& space, const Arc& arc) {
  return test::least_distance_to_blocked(space, arc.from.point(),
                                         [&](Cell cell) { return distance(arc, cell); });
}

/// From the nearest of so many points to the nearest obstacle; shares no code with what it checks.
double sampled(const FreeSpace& space, const Arc& arc, int samples) {
  double least = test::kInfinite;
  for (int i = 0; i <= samples; ++i) {
    least = std::min(least, test::clearance_at(space, point_on(arc, arc.length * i / samples)));
  }
  return least;
}

/// On maps with y up and down and of several resolutions, for points, discs and, as they come near
/// obstacles, discs that just fit.
template <class Check>
void on_random_arcs(int maps, int largest, Check&& check) {
  for (int seed = 1; seed <= maps && !::testing::Test::HasFailure(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map =
        test::random_map(random, random.between(1, largest), random.between(1, largest));
    const FreeSpace space(map, test::random_robot(random, map.frame().resolution));
    for (int i = 0; i < 20; ++i) {
      const Arc arc = test::random_arc(random, map.width(), map.height());
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " + test::text_of(arc) + "\n" +
                   test::drawing_of(map));
      check(space, arc);
    }
  }
}

TEST(ArcClearance, IsTheDistanceOfTheNearestObstacle) {
  on_random_arcs(400, 14, [](const FreeSpace& space, const Arc& arc) {
    const double expected = brute_force(space, arc);
    if (expected == test::kInfinite) {
      ASSERT_EQ(arc_clearance(space, arc), expected);
    } else {
      ASSERT_NEAR(arc_clearance(space, arc), expected, 1e-12);
    }
  });
}

TEST(ArcClearance, IsThatOfTheNearestPoint) {
  constexpr int kSamples = 60;
  on_random_arcs(60, 8, [](const FreeSpace& space, const Arc& arc) {
    const double least = sampled(space, arc, kSamples);
    const double clearance = arc_clearance(space, arc);
    ASSERT_LE(clearance, least + 1e-12);
    if (least == test::kInfinite) return;
    ASSERT_GE(clearance, least - std::abs(arc.length) / kSamples / 2 - 1e-12);
  });
}

TEST(ArcClearance, FindsObstaclesFarAwayOnLargeMaps) {
  Grid<CellState> cells(300, 200, CellState::free);
  cells[{130, 7}] = CellState::occupied;
  const FreeSpace space((GridMap(cells)));
  EXPECT_DOUBLE_EQ(arc_clearance(space, {{300, 200, 0}, 0, 0}), std::hypot(169, 192));
  EXPECT_DOUBLE_EQ(arc_clearance(space, {{0, 0, 0}, 300, 0}), 7);
  EXPECT_DOUBLE_EQ(arc_clearance(space, arc_to({0, 200, -kPi / 4}, {200, 0})), 61 * std::sqrt(0.5));
  // A circle around (130,100), of radius 50.
  EXPECT_DOUBLE_EQ(arc_clearance(space, {{130, 150, 0}, 100 * kPi, -0.02}), 42);
}

TEST(FitsAlong, SaysWhetherEveryObstacleIsFarEnough) {
  int fitting = 0;
  int too_near = 0;
  on_random_arcs(800, 14, [&](const FreeSpace& space, const Arc& arc) {
    if (space.radius_in_cells() == 0) return;
    const double clearance = brute_force(space, arc);
    const bool fits = clearance >= space.radius_in_cells() - 1e-9;
    ASSERT_EQ(fits_along(space, arc), fits) << clearance << " for " << space.radius_in_cells();
    ++(fits ? fitting : too_near);
  });
  EXPECT_GT(fitting, 500);
  EXPECT_GT(too_near, 500);
}

TEST(FitsAlong, SaysTheSameOfALineAndOfAnArcThatDoesNotBend) {
  on_random_arcs(300, 14, [&](const FreeSpace& space, const Arc& arc) {
    const Arc straight{arc.from, arc.length, 0};
    const Line line{arc.from.point(), end_of(straight).point()};
    ASSERT_EQ(fits_along(space, line), fits_along(space, straight));
    if (space.radius_in_cells() == 0) return;
    const bool fits = brute_force(space, straight) >= space.radius_in_cells() - 1e-9;
    ASSERT_EQ(fits_along(space, line), fits);
  });
}

/// A disc of just the arc's clearance may touch; rounding does not decide.
TEST(FitsAlong, LetsDiscsTouch) {
  on_random_arcs(400, 10, [&](const FreeSpace& space, const Arc& arc) {
    const double clearance = brute_force(space, arc);
    if (clearance < 1e-3 || clearance == test::kInfinite) return;
    const double metres = clearance * space.map().frame().resolution;
    for (const double larger : {-1e-3, -1e-6, -1e-11, 0.0, 1e-11, 1e-6, 1e-3}) {
      const FreeSpace just(space.map(), {.robot_radius = metres * (1 + larger),
                                         .unknown = space.options().unknown,
                                         .outside = space.outside()});
      ASSERT_EQ(fits_along(just, arc), larger < 1e-9) << clearance << ", larger by " << larger;
    }
  });
}

FreeSpace with_radius(const FreeSpace& space, double radius) {
  return FreeSpace(space.map(), {.robot_radius = radius});
}

TEST(FitsAlong, JudgesMovesOfACarByRadiiThatTouchExactly) {
  const FreeSpace space = test::drawn_space("...\n...\n.#.");
  const Arc line = arc_to({0, 1, 0}, {3, 1});
  EXPECT_TRUE(fits_along(with_radius(space, 1), line));
  EXPECT_FALSE(fits_along(with_radius(space, 1.001), line));
  // Around (0,0) from the left of the obstacle's row to the top, past its corner (1,2).
  const Arc turn = arc_to({0, 1, 0}, {1, 0});
  EXPECT_TRUE(fits_along(with_radius(space, std::sqrt(5) - 1), turn));
  EXPECT_FALSE(fits_along(with_radius(space, std::sqrt(5) - 0.999), turn));
}

TEST(FitsAlong, KeepsPointsOutOfObstaclesToo) {
  const FreeSpace space = test::drawn_space("##\n##");
  EXPECT_FALSE(fits_along(space, arc_to({0, 0, 0}, {1, 1})));
  EXPECT_TRUE(fits_along(space, arc_to({0, 0, 0}, {2, 0})));
  EXPECT_FALSE(fits_along(with_radius(space, 1e-9), arc_to({0, 0, 0}, {2, 0})));
}

/// Walls do not grow from the map's edge, and a small disc fits between two obstacles.
TEST(FitsAlong, IsAllowedOnTheBorderAndBetweenObstacles) {
  const FreeSpace space = with_radius(test::drawn_space("#.#\n...\n..."), 0.5);
  EXPECT_TRUE(fits_along(space, arc_to({0, 2, kPi}, {-1, 3})));
  EXPECT_TRUE(fits_along(space, arc_to({3, 3, 0}, {0, 3})));
  EXPECT_TRUE(fits_along(space, arc_to({1.5, 3, -kPi / 2}, {1.5, -1})));
  EXPECT_FALSE(fits_along(space, arc_to({1.4, 3, -kPi / 2}, {1.4, -1})));
  const FreeSpace small = with_radius(space, 0.3);
  EXPECT_TRUE(fits_along(small, arc_to({1.4, 3, -kPi / 2}, {1.4, -1})));
}

}  // namespace
}  // namespace wend
