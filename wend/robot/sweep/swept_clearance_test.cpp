#include "wend/robot/sweep/swept_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "conformance/random_map.hpp"
#include "tests/testing/blocked_squares.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_arc.hpp"
#include "tests/testing/share.hpp"
#include "wend/geometry/arc_distance.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/map/random_bits_test.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/point_sweep.hpp"

namespace wend {
namespace {

/// The least distance over all squares that count.
double brute_force(const FreeSpace& space, const Arc& arc) {
  return test::least_distance_to_blocked(space, arc.from.point(),
                                         [&](Cell cell) { return distance(arc, cell); });
}

/// The least clearance of `samples` points of the arc; shares no code with what it checks.
double sampled(const FreeSpace& space, const Arc& arc, int samples) {
  double least = test::kInfinite;
  for (int i = 0; i <= samples; ++i) {
    least = std::min(least, test::clearance_at(space, point_on(arc, arc.length * i / samples)));
  }
  return least;
}

/// Calls check on maps with y up and down and several resolutions, for points, discs and, because they
/// come near obstacles, discs that just fit.
template <class Check>
void on_random_arcs(int maps, int largest, Check&& check) {
  for (int seed = 1; seed <= maps && !::testing::Test::HasFailure(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map =
        test::random_map(random, random.between(1, largest), random.between(1, largest));
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
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
  const FreeSpace space = *make_free_space((*make_grid_map(cells)));
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

/// A disc whose radius is exactly the arc's clearance may touch; rounding does not decide.
TEST(FitsAlong, LetsDiscsTouch) {
  on_random_arcs(400, 10, [&](const FreeSpace& space, const Arc& arc) {
    const double clearance = brute_force(space, arc);
    if (clearance < 1e-3 || clearance == test::kInfinite) return;
    const double metres = clearance * space.map().frame().resolution;
    for (const double larger : {-1e-3, -1e-6, -1e-11, 0.0, 1e-11, 1e-6, 1e-3}) {
      const FreeSpace just =
          *make_free_space(space.map(), {.footprint = Footprint::disc(metres * (1 + larger)),
                                         .unknown = space.options().unknown,
                                         .outside = space.outside()});
      ASSERT_EQ(fits_along(just, arc), larger < 1e-9) << clearance << ", larger by " << larger;
    }
  });
}

FreeSpace with_radius(const FreeSpace& space, double radius) {
  return *make_free_space(space.map(), {.footprint = Footprint::disc(radius)});
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

/// The map's edge is not a wall, and a small disc fits between two obstacles.
TEST(FitsAlong, IsAllowedOnTheBorderAndBetweenObstacles) {
  const FreeSpace space = with_radius(test::drawn_space("#.#\n...\n..."), 0.5);
  EXPECT_TRUE(fits_along(space, arc_to({0, 2, kPi}, {-1, 3})));
  EXPECT_TRUE(fits_along(space, arc_to({3, 3, 0}, {0, 3})));
  EXPECT_TRUE(fits_along(space, arc_to({1.5, 3, -kPi / 2}, {1.5, -1})));
  EXPECT_FALSE(fits_along(space, arc_to({1.4, 3, -kPi / 2}, {1.4, -1})));
  const FreeSpace small = with_radius(space, 0.3);
  EXPECT_TRUE(fits_along(small, arc_to({1.4, 3, -kPi / 2}, {1.4, -1})));
}

constexpr double kExact = 1e-7;  // squared distances are multiples of 1/8 or of 1 / length^2

/// The least over all squares that count, by ternary search along the way.
double brute_force(const FreeSpace& space, Cell from, Cell to) {
  return test::least_distance_to_blocked(
      space, centre_of(from), [&](Cell cell) { return test::distance_to_square(from, to, cell); });
}

template <class Check>
void on_random_spaces(int count, Check&& check) {
  for (int seed = 1; seed <= count && !::testing::Test::HasFailure(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = test::random_map(random, random.between(1, 14), random.between(1, 14));
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    check(random, space);
  }
}

TEST(WayClearance, OfANeighbourIsTheDistanceOfTheWholeWay) {
  int nearer_in_the_middle = 0;
  on_random_spaces(test::share_of(50), [&](Random&, const FreeSpace& space) {
    for (const Cell from : test::all_cells(space.width(), space.height())) {
      for (const Cell step : {Cell{0, 0}, Cell{1, 0}, Cell{-1, 1}, Cell{0, 1}, Cell{1, 1}}) {
        const Cell to{from.x + step.x, from.y + step.y};
        if (!space.contains(to)) continue;
        const double expected = brute_force(space, from, to);
        const std::uint32_t squared = squared_half_cell_way_clearance(space, from, to);
        ASSERT_EQ(squared, squared_half_cell_way_clearance(space, to, from));
        if (expected == test::kInfinite) {
          ASSERT_EQ(squared, kNoObstacle);
          continue;
        }
        ASSERT_NEAR(std::sqrt(squared) / 2, expected, kExact)
            << from.x << "," << from.y << " to " << to.x << "," << to.y;
        const double at_ends = std::min(space.clearance(from), space.clearance(to));
        nearer_in_the_middle += expected > 0.1 && expected < at_ends - kExact ? 2 : 0;
      }
    }
  });
  EXPECT_GT(nearer_in_the_middle, test::share_of(test::share_of(50)))
      << "too few gaps to say anything";
}

TEST(WayClearance, OfAnyTwoCellsIsTheDistanceOfTheWholeWay) {
  on_random_spaces(test::share_of(150), [](Random& random, const FreeSpace& space) {
    for (int i = 0; i < 20; ++i) {
      const Cell from = test::random_cell(random, space.width(), space.height());
      const Cell to = test::random_cell(random, space.width(), space.height());
      const double expected = brute_force(space, from, to);
      const double clearance = way_clearance(space, from, to);
      const double back = way_clearance(space, to, from);
      if (expected == test::kInfinite) {
        ASSERT_EQ(clearance, expected);
        ASSERT_EQ(back, expected);
      } else {
        ASSERT_NEAR(clearance, expected, kExact)
            << from.x << "," << from.y << " to " << to.x << "," << to.y;
        ASSERT_NEAR(clearance, back, kExact);
      }
    }
  });
}

/// So without corner cutting a disc's way along a diagonal step need not be checked.
TEST(WayClearance, IsWideEnoughForAnyRobotThatMayStandOnAllFourCells) {
  on_random_spaces(400, [](Random&, const FreeSpace& space) {
    const auto& clearance = space.squared_half_cell_clearance();
    for (int y = 0; y + 1 < space.height(); ++y) {
      for (int x = 0; x + 1 < space.width(); ++x) {
        const std::uint32_t least = std::min({clearance[{x, y}], clearance[{x + 1, y}],
                                              clearance[{x, y + 1}], clearance[{x + 1, y + 1}]});
        ASSERT_GE(squared_half_cell_way_clearance(space, {x, y}, {x + 1, y + 1}), least);
        ASSERT_GE(squared_half_cell_way_clearance(space, {x + 1, y}, {x, y + 1}), least);
      }
    }
  });
}

TEST(WayClearance, IsNothingWhereACornerIsCut) {
  const FreeSpace space = test::drawn_space("...\n.#.\n...");
  EXPECT_EQ(squared_half_cell_way_clearance(space, {1, 0}, {2, 1}), 0U);
  EXPECT_EQ(squared_half_cell_way_clearance(space, {0, 0}, {1, 0}), 1U);
  EXPECT_EQ(way_clearance(space, {0, 0}, {2, 2}), 0);
  EXPECT_EQ(way_clearance(space, {0, 0}, {2, 0}), 0.5);
}

/// Between two corners the middle is nearest, which no cell's clearance shows.
TEST(WayClearance, SeesTheMiddleOfAGap) {
  const FreeSpace space = test::drawn_space("#...\n....\n....\n...#");
  // The gap's corners are (1,1) and (3,3), the lattice corner between them is (2,2).
  EXPECT_EQ(squared_half_cell_way_clearance(space, {2, 1}, {1, 2}), 8U);
  EXPECT_DOUBLE_EQ(way_clearance(space, {1, 2}, {2, 1}), std::sqrt(2));
  EXPECT_DOUBLE_EQ(space.clearance({1, 2}), std::sqrt(10) / 2);
}

Line random_line(Random& random, const GridMap& map) {
  const double most = test::one_of<double>(random, std::array{0.0, 1.0, 3.0, 12.0});
  const Point from{test::number_between(random, -1, map.width() + 1),
                   test::number_between(random, -1, map.height() + 1)};
  return {from,
          {from.x + test::number_between(random, -most, most),
           from.y + test::number_between(random, -most, most)}};
}

Point near(Random& random, Point point, double distance) {
  const double heading = test::number_between(random, -kPi, kPi);
  return {point.x + distance * std::cos(heading), point.y + distance * std::sin(heading)};
}

TEST(LineRoom, IsWhatBothEndsMayMove) {
  int roomy = 0;
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 4000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 14), random.between(1, 14));
    const double radius = test::one_of<double>(random, std::array{0.0, 0.0, 0.3, 1.0, 2.7});
    const FreeSpace space =
        *make_free_space(map, {.footprint = Footprint::disc(radius * map.frame().resolution)});
    const Line line = random_line(random, map);
    const auto room = room_along(space, line);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    ASSERT_EQ(room.has_value(), fits_along(space, line));
    ++(room ? roomy : blocked);
    if (!room) continue;
    ASSERT_GE(*room, 0);
    ASSERT_LE(*room, kMostRoom);
    for (int i = 0; i < 10; ++i) {
      const Line moved{near(random, line.from, *room * (1 - 1e-9)),
                       near(random, line.to, *room * (1 - 1e-9))};
      ASSERT_TRUE(fits_along(space, moved)) << *room;
    }
    // If the result is below kMostRoom / 2, there is no more room.
    if (*room >= kMostRoom / 2) continue;
    const Arc arc{
        {line.from.x, line.from.y, std::atan2(line.to.y - line.from.y, line.to.x - line.from.x)},
        line.length(),
        0};
    ASSERT_NEAR(*room, std::max(arc_clearance(space, arc) - radius, 0.0), 1e-9);
  }
  EXPECT_GT(roomy, 1000);
  EXPECT_GT(blocked, 1000);
}

TEST(LineRoom, IsNotKnownInAGap) {
  const FreeSpace space = test::drawn_space("#.\n.#");
  const Line into{{0.5, 1.5}, {1, 1}};
  const Line out_of{{1, 1}, {0.5, 1.5}};
  EXPECT_TRUE(fits_along(space, into));
  EXPECT_FALSE(room_along(space, into));
  EXPECT_FALSE(room_along(space, out_of));
  EXPECT_EQ(room_along(space, into, Adjacency::edges_and_corners), 0);
  EXPECT_EQ(room_along(space, {{0.5, 1.5}, {0.5, 1}}), 0) << "at an edge";
}

}  // namespace
}  // namespace wend
