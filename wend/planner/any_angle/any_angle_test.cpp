// any_angle against an independent search on all lines between corners, in whole numbers.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/visibility.hpp"
#include "tests/testing/random_cells.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/planner/any_angle/prepared_sight.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

constexpr double kRelative = 1e-9;

bool is_wrong(const Planner& planner, const test::Visibility& visibility, Cell start, Cell goal,
              double length, Status status, const Plan& plan) {
  if (status != Status::found) return std::isfinite(length);
  if (!(std::abs(plan.cost - length) <= kRelative * (1 + length))) return true;
  if (!visibility.fault(plan.path.waypoints(), start, centre_of(goal)).empty()) return true;
  return plan.bound != 1 || plan.cost != plan.path.length() ||
         planner.grid_moves()->connectivity != Connectivity::eight;
}

GridMap map_of(const BitGrid& free) {
  Grid<CellState> states(free.width(), free.height(), CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (!free[cell]) states[cell] = CellState::occupied;
  }
  return *make_grid_map(states);
}

/// All pairs of cells, or from some of them to all others. The number of queries.
int expect_shortest(const BitGrid& free, CornerRule rule, int starts, std::uint64_t seed) {
  const GridMap map = map_of(free);
  test::Visibility visibility(
      free.width(), free.height(), [&](Cell cell) { return free[cell]; }, rule == CornerRule::both);
  visibility.join_corners();
  Random random(seed);
  int queries = 0;
  Plan plan;
  const auto from = [&](Cell start) {
    if (!free[start]) return;
    const std::vector<double> lengths = visibility.lengths_from(start);
    // A new space: the first queries know nothing of it, the last ones all.
    const FreeSpace space = *make_free_space(map);
    const auto planner = make_planner(space, ShortestAnyAngleOptions{.corner_rule = rule});
    for (const Cell goal : every_cell(map)) {
      if (!free[goal]) continue;
      const Status status = (*planner)->plan(Query::between(start, goal), plan);
      const double length = lengths[visibility.number(goal.x, goal.y)];
      ++queries;
      if (!is_wrong(**planner, visibility, start, goal, length, status, plan)) continue;
      ADD_FAILURE() << "from " << start.x << ',' << start.y << " to " << goal.x << ',' << goal.y
                    << ": " << to_string(status) << ", cost " << plan.cost << ", expected "
                    << length << ' '
                    << visibility.fault(plan.path.waypoints(), start, centre_of(goal)) << " seed "
                    << seed << '\n'
                    << test::drawing_of(map);
      return;
    }
  };
  if (starts == 0) {
    for (const Cell start : every_cell(map)) from(start);
  } else {
    for (int i = 0; i < starts; ++i) {
      const Cell start = test::random_cell(random, free.width(), free.height());
      from(start);
    }
  }
  return queries;
}

/// Cells [0, width) x [0, height), of which bit x + y width is set where they are free.
BitGrid cells_of(int width, int height, std::uint64_t bits) {
  BitGrid cells(width, height);
  for (int i = 0; i < width * height; ++i) {
    cells.set({i % width, i / width}, ((bits >> static_cast<unsigned>(i)) & 1U) != 0);
  }
  return cells;
}

CornerRule random_rule(Random& random) {
  const int number = random.between(0, 3);
  return number == 0 ? CornerRule::none : number == 1 ? CornerRule::one : CornerRule::both;
}

int expect_shortest_on_random_maps(std::uint64_t first, std::uint64_t count) {
  int queries = 0;
  for (std::uint64_t seed = first; seed < first + count && !::testing::Test::HasFailure(); ++seed) {
    Random random(seed);
    const int longest = seed % 10 == 0 ? 14 : 7;
    const BitGrid free = test::random_cells(random, longest, 0.4);
    const CornerRule rule = random_rule(random);
    queries += expect_shortest(free, rule, 2, seed);
  }
  return queries;
}

TEST(ShortestAnyAngle, IsShortestOnRandomMaps) {
  EXPECT_GT(expect_shortest_on_random_maps(1, 3000), 20'000);
}

TEST(ShortestAnyAngle, IsShortestOnAHundredThousandRandomMapsLongRun) {
  EXPECT_GT(expect_shortest_on_random_maps(10'000, 100'000), 1'000'000);
}

TEST(ShortestAnyAngle, IsShortestOnAllMapsOfNineCells) {
  for (std::uint64_t bits = 0; bits < 512 && !HasFailure(); ++bits) {
    expect_shortest(cells_of(3, 3, bits), CornerRule::none, 0, 1);
    expect_shortest(cells_of(3, 3, bits), CornerRule::both, 0, 1);
  }
}

TEST(ShortestAnyAngle, IsShortestOnAllMapsOfSixteenCellsLongRun) {
  for (std::uint64_t bits = 0; bits < 65536 && !HasFailure(); ++bits) {
    expect_shortest(cells_of(4, 4, bits), CornerRule::none, 0, 1);
    expect_shortest(cells_of(4, 4, bits), CornerRule::both, 0, 1);
  }
}

/// What the queries of many maps come to.
struct Lengths {
  int queries = 0;
  int longer = 0;  // than the taut path of A*
  double any_angle = 0;
  double taut = 0;
};

FreeSpaceOptions random_robot_with_size(Random& random) {
  const double ahead = 0.3 + random.uniform();
  const double side = 0.2 + 0.6 * random.uniform();
  if (random.chance(0.5)) return {.footprint = Footprint::disc(ahead)};
  return {.footprint = *Footprint::polygon(
              *Polygon::make({{ahead, side}, {-side, side}, {-side, -side}, {ahead, -side}}))};
}

/// One query on one map, with a robot that is not a point.
void compare_with_taut_astar(std::uint64_t seed, Lengths& lengths) {
  Random random(seed);
  const int width = random.between(4, 24);
  const int height = random.between(4, 24);
  const double blocked = 0.25 * random.uniform();
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(blocked)) states[cell] = CellState::occupied;
  }
  const FreeSpace space = *make_free_space(*make_grid_map(states), random_robot_with_size(random));
  const CornerRule rule = random_rule(random);
  const auto planner = make_planner(space, ShortestAnyAngleOptions{.corner_rule = rule});
  const auto astar = make_planner(space, AStarOptions{.moves = {Connectivity::eight, rule}});
  const Adjacency adjacency = GridMoves{Connectivity::eight, rule}.adjacency();
  const Cell start = test::random_cell(random, width, height);
  const Cell goal = test::random_cell(random, width, height);
  Plan plan;
  Plan reference;
  ASSERT_EQ((*planner)->plan(Query::between(start, goal), plan),
            (*astar)->plan(Query::between(start, goal), reference));
  if (plan.path.empty()) return;
  const auto collision = first_collision(plan.path, space, adjacency);
  ASSERT_FALSE(collision) << describe(collision->kind);
  EXPECT_EQ(plan.cost, plan.path.length());
  EXPECT_EQ(plan.bound, Plan::kNoBound) << "the shortest path is known for points only";
  const double taut = string_pulled(reference.path, space, adjacency)->length();
  ++lengths.queries;
  lengths.longer += plan.cost > taut * (1 + kRelative) ? 1 : 0;
  lengths.any_angle += plan.cost;
  lengths.taut += taut;
}

TEST(ShortestAnyAngle, LeadsDiscsAndPolygonsAlongFreePathsWhereverAStarDoes) {
  Lengths lengths;
  for (std::uint64_t seed = 1; seed <= test::share_of(6000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    compare_with_taut_astar(seed, lengths);
  }
  std::cout << "longer than the taut path of A* in " << lengths.longer << " of " << lengths.queries
            << " queries, on average " << lengths.any_angle / lengths.taut << " times as long\n";
  EXPECT_GT(lengths.queries, 300);
  EXPECT_LE(lengths.any_angle, 1.002 * lengths.taut) << "it knows the best way of a point only";
  EXPECT_LT(5 * lengths.longer, lengths.queries);
}

/// Each cell as 3 x 3 of them: their centres are other points of the cell than its centre.
constexpr int kParts = 3;

BitGrid divided(const BitGrid& free) {
  BitGrid parts(kParts * free.width(), kParts * free.height());
  for (const Cell part : every_cell(parts))
    parts.set(part, free[{part.x / kParts, part.y / kParts}]);
  return parts;
}

Point middle_of_part(Cell part) { return {(part.x + 0.5) / kParts, (part.y + 0.5) / kParts}; }

/// From a few points inside cells to all others, on a map that it does not know or knows. The number of queries.
int expect_shortest_between_points(std::uint64_t seed, bool is_known) {
  Random random(seed);
  const BitGrid free = test::random_cells(random, 6, 0.4);
  const CornerRule rule = random_rule(random);
  const BitGrid parts = divided(free);
  test::Visibility visibility(
      parts.width(), parts.height(), [&](Cell part) { return parts[part]; },
      rule == CornerRule::both);
  visibility.join_corners();
  const FreeSpace space = *make_free_space(map_of(free));
  const auto planner = *make_planner(space, ShortestAnyAngleOptions{.corner_rule = rule});
  const Adjacency adjacency = planner->grid_moves()->adjacency();
  if (is_known) {
    const auto prepared = PreparedSight::of(space);
    const auto portals = prepared->portals(space, adjacency);
    prepared->count(portals, portals->corners().size());
  }
  const Cell start = test::random_cell(random, parts.width(), parts.height());
  if (!parts[start]) return 0;
  const std::vector<double> lengths = visibility.lengths_from(start);
  int queries = 0;
  for (const Cell goal : every_cell(map_of(parts))) {
    if (!parts[goal]) continue;
    const double length = lengths[visibility.number(goal.x, goal.y)] / kParts;
    const Point from = middle_of_part(start);
    const Query query{{from.x, from.y, 0}, {Goal(middle_of_part(goal))}};
    Plan plan;
    const Status status = planner->plan(query, plan);
    ++queries;
    EXPECT_EQ(status == Status::found, std::isfinite(length));
    if (status != Status::found) continue;
    EXPECT_NEAR(plan.cost, length, 1e-5 * (1 + length));
    EXPECT_EQ(plan.path.waypoints().front(), middle_of_part(start));
    EXPECT_EQ(plan.path.waypoints().back(), middle_of_part(goal));
    EXPECT_FALSE(first_collision(plan.path, space, adjacency));
    if (::testing::Test::HasFailure()) {
      std::cout << "seed " << seed << " to " << goal.x << ',' << goal.y << '\n'
                << test::drawing_of(map_of(parts));
      return queries;
    }
  }
  return queries;
}

TEST(ShortestAnyAngle, IsShortestBetweenAnyPointsOfCells) {
  int queries = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(600U) && !HasFailure(); ++seed) {
    queries += expect_shortest_between_points(seed, seed % 2 == 0);
  }
  EXPECT_GT(queries, test::share_of(20'000));
}

/// Points on borders and vertices of cells too: the path begins and ends there wherever that is free.
TEST(ShortestAnyAngle, BeginsAndEndsAtPointsOnBordersOfCells) {
  int exact = 0;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(3000U) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const BitGrid free = test::random_cells(random, 12, 0.3);
    const FreeSpace space = *make_free_space(map_of(free));
    const auto planner = *make_planner(space, ShortestAnyAngleOptions{});
    const auto point = [&] {
      const Cell cell = test::random_cell(random, free.width(), free.height());
      return Point{cell.x + random.between(0, 3) / 4.0, cell.y + random.between(0, 3) / 4.0};
    };
    const Point from = point();
    const Query query{{from.x, from.y, 0}, {Goal(point())}};
    const auto plan = planner->plan(query);
    if (!plan) continue;
    ++found;
    const auto waypoints = plan->path.waypoints();
    EXPECT_LT(distance(waypoints.front(), query.start.point()), 1e-5);
    EXPECT_LT(distance(waypoints.back(), query.goals.front().point), 1e-5);
    EXPECT_FALSE(first_collision(plan->path, space));
    exact +=
        waypoints.front() == query.start.point() && waypoints.back() == query.goals.front().point
            ? 1
            : 0;
  }
  EXPECT_GT(found, test::share_of(1000));
  EXPECT_GT(exact * 100, found * 90);
}

/// 7 x 5 cells with a wall from the top, four cells long.
Grid<CellState> walled() {
  Grid<CellState> cells(7, 5, CellState::free);
  for (int y = 0; y < 4; ++y) cells[{3, y}] = CellState::occupied;
  return cells;
}

TEST(ShortestAnyAngle, TurnsAtTheCornersOfAWallAndTouchesIt) {
  const FreeSpace space = *make_free_space(*make_grid_map(walled()));
  const auto planner = make_planner(space, ShortestAnyAngleOptions{});
  const auto plan = (*planner)->plan(Query::between({2, 0}, {4, 0}));
  ASSERT_TRUE(plan);
  EXPECT_THAT(plan->path.waypoints(),
              ElementsAre(Point{2.5, 0.5}, Point{3, 4}, Point{4, 4}, Point{4.5, 0.5}));
  EXPECT_DOUBLE_EQ(plan->cost, 1 + 2 * std::sqrt(0.25 + 12.25));
}

TEST(ShortestAnyAngle, FindsTheSamePathOnceItKnowsTheMap) {
  int turns = 0;
  const int maps = test::share_of(300);
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(maps) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const BitGrid free = test::random_cells(random, 20, 0.4);
    const FreeSpace space = *make_free_space(map_of(free));
    const auto planner = make_planner(space, ShortestAnyAngleOptions{});
    const Cell start = test::random_cell(random, free.width(), free.height());
    const Cell goal = test::random_cell(random, free.width(), free.height());
    const auto first = (*planner)->plan(Query::between(start, goal));
    if (!first) continue;
    const auto prepared = PreparedSight::of(space);
    const auto portals = prepared->portals(space, Adjacency::edges);
    prepared->count(portals, portals->corners().size());
    ASSERT_NE(prepared->map(portals, [](double) { return true; }), nullptr);
    const auto second = (*planner)->plan(Query::between(start, goal));
    ASSERT_TRUE(second);
    EXPECT_EQ(first->path, second->path);
    turns += first->path.size() > 2 ? 1 : 0;
  }
  EXPECT_GT(turns, maps / 15);
}

/// A planner for which the map is worth preparing.
struct Ripe {
  explicit Ripe(const FreeSpace& space)
      : prepared(PreparedSight::of(space)),
        portals(prepared->portals(space, Adjacency::edges)),
        planner(std::move(make_planner(space, ShortestAnyAngleOptions{}).value())) {
    prepared->count(portals, portals->corners().size());
  }

  bool is_prepared() const {
    return prepared->map(portals, [](double) { return false; }) != nullptr;
  }

  std::shared_ptr<PreparedSight> prepared;
  std::shared_ptr<const Portals> portals;
  std::unique_ptr<Planner> planner;
};

FreeSpace scattered_space() {
  Random random(11);
  Grid<CellState> states(60, 60, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(0.2)) states[cell] = CellState::occupied;
  }
  states[{0, 0}] = states[{1, 0}] = states[{2, 0}] = CellState::free;
  return *make_free_space(*make_grid_map(states));
}

TEST(ShortestAnyAngle, DoesNotPrepareTheMapOnceItIsCancelled) {
  const Ripe ripe(scattered_space());
  const std::atomic<bool> cancel = true;
  Query query = Query::between({0, 0}, {2, 0});
  query.limits.cancel = &cancel;
  Plan plan;
  EXPECT_EQ(ripe.planner->plan(query, plan), Status::cancelled);
  EXPECT_FALSE(ripe.is_prepared());
  query.limits.cancel = nullptr;
  EXPECT_EQ(ripe.planner->plan(query, plan), Status::found);
  EXPECT_TRUE(ripe.is_prepared());
}

/// The clock goes on by a millisecond whenever it is read, and the time is enough for some corners.
TEST(ShortestAnyAngle, PreparesTheMapBitByBitWhereTimeIsShort) {
  const Ripe ripe(scattered_space());
  double now = 0;
  Query query = Query::between({0, 0}, {2, 0});
  query.limits.clock = [&] { return now += 0.001; };
  query.limits.seconds = 0.2;
  Plan plan;
  int queries = 0;
  for (; queries < 1000 && !ripe.is_prepared(); ++queries) {
    now = 0;
    ASSERT_EQ(ripe.planner->plan(query, plan), Status::found);
    EXPECT_LT(now, 0.2);
  }
  EXPECT_GT(queries, static_cast<int>(ripe.portals->corners().size()) / 200);
  EXPECT_LT(queries, static_cast<int>(ripe.portals->corners().size()) / 50);
}

TEST(ShortestAnyAngle, RefusesTerrainAndClearanceCosts) {
  Grid<double> terrain(2, 1, 1);
  terrain[{1, 0}] = 3;
  const GridMap uneven = *make_grid_map(Grid<CellState>(2, 1, CellState::free), {}, terrain);
  EXPECT_EQ(make_planner(*make_free_space(uneven), ShortestAnyAngleOptions{}).error().status,
            Status::unsupported_map);
}

TEST(ShortestAnyAngle, SeesWhatAnEditOpensAndCloses) {
  for (std::uint64_t seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    GridMap map = test::random_map(random);
    if (!map.uniform_terrain()) continue;
    FreeSpace space = *make_free_space(map);
    const auto planner = make_planner(space, ShortestAnyAngleOptions{});
    ASSERT_TRUE(planner);
    const Cell start = test::random_cell(random, map.width(), map.height());
    const Cell goal = test::random_cell(random, map.width(), map.height());
    Plan plan;
    (*planner)->plan(Query::between(start, goal), plan);
    const Cell cell = test::random_cell(random, map.width(), map.height());
    MapEdit edit{.corner = cell, .states = Grid<CellState>(1, 1, CellState::free)};
    if (random.chance(0.5)) edit.states[{0, 0}] = CellState::occupied;
    const auto change = space.edit(edit);
    ASSERT_TRUE(change);
    ASSERT_TRUE((*planner)->update(space, *change));
    const Status status = (*planner)->plan(Query::between(start, goal), plan);
    const auto fresh = make_planner(space, ShortestAnyAngleOptions{});
    Plan expected;
    EXPECT_EQ(status, (*fresh)->plan(Query::between(start, goal), expected));
    EXPECT_EQ(plan.path, expected.path);
  }
}

}  // namespace
}  // namespace wend
