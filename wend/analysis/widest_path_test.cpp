#include "wend/analysis/widest_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "tests/testing/blocked_squares.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr double kExact = 1e-7;

/// The same cells with other terrain.
template <class Terrain>
GridMap with_terrain(const GridMap& map, Terrain&& terrain_of) {
  Grid<CellState> states(map.width(), map.height());
  Grid<double> terrain(map.width(), map.height());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      states[{x, y}] = map.state({x, y});
      terrain[{x, y}] = terrain_of(Cell{x, y});
    }
  }
  return *make_grid_map(states, map.frame(), std::move(terrain));
}

/// Every radius at which anything changes, largest first: the clearances of all cells, those of the
/// middle of a gap between two corners, and that of a point.
std::vector<double> radii_that_matter(const FreeSpace& space) {
  std::vector<double> radii{0};
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      radii.push_back(test::clearance_at(space, centre_of(Cell{x, y})));
    }
  }
  for (int k = 1; k < std::max(space.width(), space.height()); ++k) {
    radii.push_back(k * std::numbers::sqrt2);
  }
  std::sort(radii.begin(), radii.end(), std::greater<>());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

/// What the reference says of a map and moves for a robot of a radius in cells.
struct Truth {
  GridMap map;
  FreeSpace space;
  GridMoves moves;
  Cell start;
  Cell goal;

  test::Reference reference(double radius) const {
    const int corners = static_cast<int>(moves.corner_rule);
    return {map,
            {.radius = radius,
             .enters_unknown = space.options().unknown == UnknownPolicy::free,
             .stays_on_map = space.outside() == OutsidePolicy::blocked},
            {moves.connectivity == Connectivity::eight, corners}};
  }

  bool gets_through(double radius) const {
    const test::Reference book = reference(radius);
    return book.costs_from(start)[book.number(goal)] < test::kInfinite;
  }

  /// The largest radius that gets through; nothing if none does.
  std::optional<double> widest() const {
    for (const double radius : radii_that_matter(space)) {
      if (gets_through(std::min(radius, 1e6))) return radius;
    }
    return std::nullopt;
  }
};

template <class Check>
void on_random_queries(int count, Check&& check) {
  for (int seed = 1; seed <= test::share_of(count) && !::testing::Test::HasFailure(); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = test::random_map(random, random.between(1, 9), random.between(1, 9));
    const FreeSpace space =
        *make_free_space(map, test::random_robot(random, map.frame().resolution));
    const GridMoves moves{random.chance(0.8) ? Connectivity::eight : Connectivity::four,
                          static_cast<CornerRule>(random.between(0, 2))};
    for (int i = 0; i < 3; ++i) {
      const Truth truth{map, space, moves, test::random_cell(random, map.width(), map.height()),
                        test::random_cell(random, map.width(), map.height())};
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " +
                   std::string(choice_name(moves.connectivity)) + " neighbours, corner rule " +
                   std::string(choice_name(moves.corner_rule)) + ", from (" +
                   std::to_string(truth.start.x) + "," + std::to_string(truth.start.y) + ") to (" +
                   std::to_string(truth.goal.x) + "," + std::to_string(truth.goal.y) + ")\n" +
                   test::drawing_of(map));
      check(truth, widest_path(space, truth.start, truth.goal, moves));
    }
  }
}

TEST(WidestPath, HasTheLargestRadiusThatGetsThrough) {
  int points = 0;
  int discs = 0;
  on_random_queries(800, [&](const Truth& truth, const std::optional<WidestPath>& widest) {
    const std::optional<double> expected = truth.widest();
    ASSERT_EQ(widest.has_value(), expected.has_value());
    if (!expected) return;
    if (*expected == test::kInfinite) {
      ASSERT_EQ(widest->radius, test::kInfinite);
      return;
    }
    ASSERT_NEAR(widest->radius, *expected, kExact);
    (widest->radius == 0 ? points : discs) += 1;
  });
  EXPECT_GT(points, test::share_of(8));
  EXPECT_GT(discs, test::share_of(200));
}

TEST(WidestPath, EntersAsFewNarrowCellsAsPossible) {
  int detours = 0;
  on_random_queries(400, [&](const Truth& truth, const std::optional<WidestPath>& widest) {
    if (!widest || widest->radius == test::kInfinite) return;
    const auto cells = widest->path.cells();
    ASSERT_EQ(truth.reference(widest->radius).fault(cells, truth.start, truth.goal), "");
    const auto is_narrow = [&](Cell cell) {
      return test::clearance_at(truth.space, centre_of(cell)) <= widest->radius + kExact;
    };
    // A robot that pays for nothing but narrow cells, by the reference.
    const GridMap dear =
        with_terrain(truth.map, [&](Cell cell) { return is_narrow(cell) ? 1e6 : 1.0; });
    const Truth paying{dear, truth.space, truth.moves, truth.start, truth.goal};
    const test::Reference book = paying.reference(widest->radius);
    const double least = book.costs_from(truth.start)[book.number(truth.goal)];
    ASSERT_NEAR(book.cost_of(cells), least, 1e-6 * least);
    const test::Reference plain = truth.reference(widest->radius);
    const double fewest = plain.steps_from(truth.start)[plain.number(truth.goal)];
    if (static_cast<double>(cells.size() - 1) > fewest) ++detours;
  });
  EXPECT_GT(detours, test::share_of(5)) << "else the shortest path would do";
}

TEST(WidestPath, IsNarrowestWhereAnObstacleIsAsFarAsTheRadius) {
  on_random_queries(400, [](const Truth& truth, const std::optional<WidestPath>& widest) {
    if (!widest) return;
    const double clearance = test::clearance_at(truth.space, widest->narrowest);
    if (widest->radius == test::kInfinite) {
      ASSERT_EQ(clearance, test::kInfinite);
    } else {
      ASSERT_NEAR(clearance, widest->radius, kExact);
    }
    const auto cells = widest->path.cells();
    ASSERT_TRUE(std::any_of(cells.begin(), cells.end(), [&](Cell cell) {
      return distance(centre_of(cell), widest->narrowest) <= 1;
    })) << "on the path or beside it";
  });
}

/// A robot that is a little wider comes to it from the start, but not past it.
TEST(WidestPath, IsNarrowestWhereAWiderRobotIsStuck) {
  int stuck_on_the_way = 0;
  on_random_queries(400, [&](const Truth& truth, const std::optional<WidestPath>& widest) {
    if (!widest || widest->radius == test::kInfinite) return;
    const test::Reference wider = truth.reference(widest->radius + 1e-5);
    const auto reached = wider.costs_from(truth.start);
    if (!wider.passable(truth.start)) {
      ASSERT_EQ(widest->narrowest, centre_of(truth.start));
      return;
    }
    ++stuck_on_the_way;
    const auto cells = widest->path.cells();
    std::size_t last = cells.size() - 1;
    while (reached[wider.number(cells[last])] == test::kInfinite) --last;
    ASSERT_LT(last, cells.size() - 1) << "the wider robot gets through";
    ASSERT_LE(distance(centre_of(cells[last]), widest->narrowest), std::numbers::sqrt2 + kExact);
    ASSERT_LE(distance(centre_of(cells[last + 1]), widest->narrowest), 1);
  });
  EXPECT_GT(stuck_on_the_way, test::share_of(50));
}

TEST(WidestPath, IsNarrowestAtAGoalInANicheThoughThePathHugsAWall) {
  const FreeSpace space = test::drawn_space(R"(
..........
.........#
..........
....#....#
..........
)");
  const auto widest = widest_path(space, {1, 2}, {9, 2});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 0.5);
  EXPECT_EQ(widest->narrowest, (Point{9.5, 2.5}));
}

/// In metres and with rounding: a FreeSpace lets a robot of that radius through, and none larger.
TEST(WidestPath, AgreesWithAPlannerOnAFreeSpaceOfThatRadius) {
  on_random_queries(400, [](const Truth& truth, const std::optional<WidestPath>& widest) {
    const auto status = [&](double radius) {
      const FreeSpace space = *make_free_space(
          truth.map, {.footprint = Footprint::disc(radius * truth.map.frame().resolution),
                      .unknown = truth.space.options().unknown,
                      .outside = truth.space.outside()});
      const auto planner =
          make_planner("astar", space,
                       {{"connectivity", std::string(choice_name(truth.moves.connectivity))},
                        {"corner_rule", std::string(choice_name(truth.moves.corner_rule))}});
      Plan plan;
      return (*planner)->plan(Query::between(truth.start, truth.goal), plan);
    };
    if (!widest) {
      ASSERT_NE(status(0), Status::found);
    } else if (widest->radius == test::kInfinite) {
      ASSERT_EQ(status(1e9), Status::found);
    } else {
      ASSERT_EQ(status(widest->radius), Status::found);
      ASSERT_NE(status(widest->radius + 1e-6), Status::found);
    }
  });
}

TEST(WidestPath, GoesThroughTheWiderDoorThoughItIsFarther) {
  const FreeSpace space = test::drawn_space(R"(
.......
...#...
.......
.......
.......
...#...
.......
...#...
.......
)");
  const auto widest = widest_path(space, {0, 4}, {6, 4});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 1.5);
  EXPECT_EQ(widest->narrowest, (Point{3.5, 3.5}));
}

TEST(WidestPath, IgnoresTheRobotOfItsSpace) {
  const FreeSpace space =
      test::drawn_space("....#\n.....\n....#", {.footprint = Footprint::disc(3)});
  const auto widest = widest_path(space, {0, 1}, {4, 1});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 0.5);
}

TEST(WidestPath, BetweenTwoCornersIsForPointsOnly) {
  const FreeSpace space = test::drawn_space(".#\n#.");
  EXPECT_FALSE(widest_path(space, {0, 0}, {1, 1}));
  EXPECT_FALSE(widest_path(space, {0, 0}, {1, 1}, {Connectivity::eight, CornerRule::one}));
  EXPECT_FALSE(widest_path(space, {0, 0}, {1, 1}, {Connectivity::four, CornerRule::both}));
  const auto widest = widest_path(space, {0, 0}, {1, 1}, {Connectivity::eight, CornerRule::both});
  ASSERT_TRUE(widest);
  EXPECT_EQ(widest->radius, 0);
  EXPECT_EQ(widest->narrowest, (Point{1, 1}));
}

TEST(WidestPath, IsEndlessOnOpenGroundAndNothingFromAnObstacle) {
  const auto open = widest_path(test::open_space(5, 4), {0, 0}, {4, 3});
  ASSERT_TRUE(open);
  EXPECT_EQ(open->radius, test::kInfinite);
  EXPECT_EQ(open->path.size(), 5U);
  const FreeSpace space = test::drawn_space("#..");
  EXPECT_FALSE(widest_path(space, {0, 0}, {2, 0}));
  EXPECT_FALSE(widest_path(space, {2, 0}, {0, 0}));
  EXPECT_EQ(widest_path(space, {2, 0}, {2, 0})->radius, 1.5);
}

}  // namespace
}  // namespace wend
