// Tests what is special about jump point search: its states, its waypoints, its counters that run out.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "conformance/reference.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/jump/jump_point_search.hpp"
#include "wend/planner/jump/known_jumps.hpp"
#include "wend/planner/jump/prepared_jumps.hpp"
#include "wend/planner/jump/scanned_jumps.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

BitGrid cells_of(const std::vector<std::string>& rows) {
  BitGrid cells(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      cells.set({x, y}, rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '.');
    }
  }
  return cells;
}

template <class Jumps>
JumpPointSearch<Jumps> make_search(const BitGrid& cells) {
  auto boards = std::make_shared<const JumpBoards>(cells);
  auto dead_ends = std::make_shared<const DeadEnds>(*boards);
  return JumpPointSearch(Jumps(std::make_shared<const JumpGraph>(boards), std::move(dead_ends)));
}

using Compact = KnownJumps<std::uint32_t>;

TEST(JumpPointSearch, GivesTheCellsWhereThePathTurns) {
  const BitGrid cells = cells_of({".#####",  //
                                  ".#...#",  //
                                  ".#.#.#",  //
                                  "...#..",  //
                                  "######"});
  auto search = make_search<Compact>(cells);
  const Limits limits;
  search.begin({0, 0}, std::array{GoalRegion(Cell{5, 3})}, limits);
  ASSERT_EQ(search.run(), SearchOutcome::found);
  EXPECT_THAT(search.waypoints(), ElementsAre(Cell{0, 0}, Cell{0, 3}, Cell{2, 3}, Cell{2, 1},
                                              Cell{4, 1}, Cell{4, 3}, Cell{5, 3}));
}

TEST(JumpPointSearch, StartAndGoalMayBeOneCell) {
  auto search = make_search<Compact>(cells_of({"...", "..."}));
  const Limits limits;
  search.begin({1, 1}, std::array{GoalRegion(Cell{1, 1})}, limits);
  ASSERT_EQ(search.run(), SearchOutcome::found);
  EXPECT_THAT(search.waypoints(), ElementsAre(Cell{1, 1}));
  EXPECT_EQ(search.metrics(), (SearchMetrics{1, 1, 1}));
}

TEST(JumpPointSearch, AGoalInSightIsFoundAtOnce) {
  auto search =
      make_search<Compact>(BitGrid(cells_of(std::vector<std::string>(200, std::string(300, '.')))));
  const Limits limits;
  search.begin({3, 199}, std::array{GoalRegion(Cell{290, 7})}, limits);
  ASSERT_EQ(search.run(), SearchOutcome::found);
  EXPECT_EQ(search.metrics().expanded, 2U) << "the start and the goal";
}

double length_of(std::span<const Cell> waypoints) {
  double length = 0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const int dx = std::abs(waypoints[i].x - waypoints[i - 1].x);
    const int dy = std::abs(waypoints[i].y - waypoints[i - 1].y);
    EXPECT_TRUE(dx == 0 || dy == 0 || dx == dy) << "no straight line of steps";
    length += dx != 0 && dy != 0 ? std::numbers::sqrt2 * dx : dx + dy;
  }
  return length;
}

/// Costs in 32 and 64 bits, and generations that run out after three searches, make no difference.
TEST(JumpPointSearch, CountersThatRunOutChangeNothing) {
  Random random(31);
  for (int map = 0; map < 40; ++map) {
    GridMap grid = test::random_map(random, 24, 18);
    const FreeSpace space = *make_free_space(grid);
    auto compact = make_search<Compact>(space.passable());
    auto wide = make_search<KnownJumps<std::uint64_t>>(space.passable());
    auto forgetful = make_search<KnownJumps<std::uint32_t, 3>>(space.passable());
    const Limits limits;
    for (int query = 0; query < 20; ++query) {
      const Cell start = test::random_cell(random, space.width(), space.height());
      const Cell goal = test::random_cell(random, space.width(), space.height());
      if (!space.components().connected(start, goal, Adjacency::edges)) continue;
      SCOPED_TRACE("map " + std::to_string(map) + ", query " + std::to_string(query));
      const auto answer = [&](auto& search) {
        search.begin(start, std::array{GoalRegion(goal)}, limits);
        EXPECT_EQ(search.run(), SearchOutcome::found);
        const auto waypoints = search.waypoints();
        return std::pair(std::vector<Cell>(waypoints.begin(), waypoints.end()),
                         search.metrics().expanded);
      };
      const auto expected = answer(compact);
      EXPECT_EQ(answer(forgetful), expected);
      EXPECT_NEAR(length_of(answer(wide).first), length_of(expected.first), 1e-9);
    }
  }
}

/// What a search finds: its outcome and its waypoints.
template <class Search>
std::pair<SearchOutcome, std::vector<Cell>> found_by(Search& search, Cell start, Cell goal) {
  const Limits limits;
  search.begin(start, std::array{GoalRegion(goal)}, limits);
  const SearchOutcome outcome = search.run();
  if (outcome != SearchOutcome::found) return {outcome, {}};
  const auto waypoints = search.waypoints();
  return {outcome, {waypoints.begin(), waypoints.end()}};
}

/// Goals that no path reaches are among the queries.
TEST(JumpPointSearch, TakesTheSamePathsOnAMapThatIsNotPrepared) {
  constexpr std::uint64_t kSeed = 32;
  Random random(kSeed);
  std::size_t found = 0;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(i));
    const FreeSpace space = *make_free_space(test::random_map(random, i % 3 == 0 ? 150 : 30, 40));
    auto known = make_search<Compact>(space.passable());
    JumpPointSearch scanned{ScannedJumps<std::uint32_t>(space.passable())};
    for (int query = 0; query < 20; ++query) {
      const Cell start = test::random_cell(random, space.width(), space.height());
      const Cell goal = test::random_cell(random, space.width(), space.height());
      if (!space.passable(start) || !space.passable(goal)) continue;
      const auto expected = found_by(known, start, goal);
      ASSERT_EQ(found_by(scanned, start, goal), expected) << "query " << query;
      JumpPointSearch fresh{ScannedJumps<std::uint32_t>(space.passable())};
      ASSERT_EQ(found_by(fresh, start, goal), expected) << "query " << query << ", fresh";
      found += expected.first == SearchOutcome::found ? 1 : 0;
    }
  }
  EXPECT_GT(found, 300U) << "or it proves little";
}

/// The planner prepares the map during these queries: it expands fewer states for the same path.
TEST(Jps, TakesTheSamePathBeforeAndAfterItHasLearned) {
  const FreeSpace space = *make_free_space(*make_map("maze", 101, 101, 3));
  const auto planner = make_planner("jps", space);
  ASSERT_TRUE(planner) << planner.error().message;
  const Query query = Query::between({1, 1}, {99, 99});
  const auto first = (*planner)->plan(query);
  ASSERT_TRUE(first) << first.error().message;
  std::uint64_t expanded = first->metrics.expanded;
  for (int i = 0; i < 200 && expanded == first->metrics.expanded; ++i) {
    const auto plan = (*planner)->plan(query);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->path, first->path) << "query " << i;
    expanded = plan->metrics.expanded;
  }
  EXPECT_LT(expanded, first->metrics.expanded) << "it has not learned";
  const auto clone = (*planner)->clone();
  EXPECT_EQ(clone->plan(query)->path, first->path);
}

/// The planner has learned before some of the edits, and not before others.
TEST(Jps, AnswersLikeANewPlannerAfterEdits) {
  constexpr std::uint64_t kSeed = 33;
  Random random(kSeed);
  GridMap map = test::random_map(random, 70, 50);
  BitGrid occupied = map.occupied();
  const auto planner = make_planner("jps", *make_free_space(map));
  ASSERT_TRUE(planner) << planner.error().message;
  std::size_t found = 0;
  for (int edit = 0; edit < 60; ++edit) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", edit " + std::to_string(edit));
    const Cell cell = test::random_cell(random, map.width(), map.height());
    occupied.set(cell, !occupied[cell]);
    map = *make_grid_map(occupied, BitGrid(map.width(), map.height()));
    const FreeSpace space = *make_free_space(map);
    ASSERT_TRUE((*planner)->update(space));
    const auto astar = make_planner("astar", space);
    for (int i = 0; i < (edit % 3 == 0 ? 60 : 5); ++i) {
      const Cell start = test::random_cell(random, map.width(), map.height());
      const Cell goal = test::random_cell(random, map.width(), map.height());
      const Query query = Query::between(start, goal);
      const auto plan = (*planner)->plan(query);
      const auto fresh = (*make_planner("jps", space))->plan(query);
      const auto expected = (*astar)->plan(query);
      ASSERT_EQ(plan.has_value(), expected.has_value()) << "query " << i;
      if (!plan) continue;
      ++found;
      ASSERT_EQ(plan->path, fresh->path) << "query " << i;
      ASSERT_NEAR(plan->cost, expected->cost, 1e-9) << "query " << i;
    }
  }
  EXPECT_GT(found, 200U) << "or it proves little";
}

/// A corridor that runs to and fro, so long that its costs exceed 32 bits.
GridMap serpentine(int width, int turns) {
  Grid<CellState> cells(width, 2 * turns + 1, CellState::free);
  for (int turn = 0; turn < turns; ++turn) {
    for (int x = 0; x + 1 < width; ++x) {
      cells[{turn % 2 == 0 ? x : x + 1, 2 * turn + 1}] = CellState::occupied;
    }
  }
  return *make_grid_map(cells);
}

TEST(Jps, FindsPathsThatOutgrow32Bits) {
  constexpr int kWidth = 3000;
  constexpr int kTurns = 50;
  const FreeSpace space = *make_free_space(serpentine(kWidth, kTurns));
  const auto planner = make_planner("jps", space);
  ASSERT_TRUE(planner);
  const Query query = Query::between({0, 0}, {kTurns % 2 == 0 ? kWidth - 1 : 0, 2 * kTurns});
  const auto plan = (*planner)->plan(query);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_GT(plan->cost, 128000) << "or it proves nothing";
  const auto astar = (*make_planner("astar", space))->plan(query);
  ASSERT_TRUE(astar);
  EXPECT_EQ(plan->cost, astar->cost);
}

/// A map so wide that the distance between two cells may exceed 32 bits.
TEST(Jps, PlansOnMapsThatAreVeryWide) {
  constexpr int kWidth = 150000;
  Grid<CellState> cells(kWidth, 3, CellState::free);
  for (int x = 0; x < kWidth; ++x) cells[{x, 1}] = CellState::occupied;
  cells[{100, 1}] = cells[{kWidth - 1, 1}] = CellState::free;
  const FreeSpace space = *make_free_space(*make_grid_map(cells));
  const auto planner = make_planner("jps", space);
  ASSERT_TRUE(planner);
  const auto plan = (*planner)->plan(Query::between({kWidth - 101, 0}, {kWidth - 1, 2}));
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->cost, 102) << "by the near gap";
  const auto far = (*planner)->plan(Query::between({0, 0}, {kWidth - 2, 2}));
  ASSERT_TRUE(far) << far.error().message;
  EXPECT_EQ(far->cost, kWidth) << "by the first gap";
}

/// The expansions of some queries, at the costs of astar, and those of astar.
std::pair<std::uint64_t, std::uint64_t> expansions_of_jps_and_astar(const GridMap& map) {
  const FreeSpace space = *make_free_space(map);
  const auto jps = *make_planner("jps", space);
  const auto astar = *make_planner("astar", space);
  Random random(7);
  std::pair<std::uint64_t, std::uint64_t> expansions;
  for (int query = 0; query < 8;) {
    const Cell start = test::random_cell(random, space.width(), space.height());
    const Cell goal = test::random_cell(random, space.width(), space.height());
    if (!space.components().connected(start, goal, Adjacency::edges)) continue;
    ++query;
    const Plan jumped = *jps->plan(Query::between(start, goal));
    const Plan stepped = *astar->plan(Query::between(start, goal));
    EXPECT_EQ(jumped.cost, stepped.cost);
    expansions.first += jumped.metrics.expanded;
    expansions.second += stepped.metrics.expanded;
  }
  return expansions;
}

TEST(Jps, SearchesLargeMapsOfNoiseAsAstarDoes) {
  for (const char* const density : {"0.01", "0.02", "0.1", "0.2", "0.35", "0.4"}) {
    const auto [jps, astar] =
        expansions_of_jps_and_astar(*make_map("random", 512, 512, 7, {{"density", density}}));
    EXPECT_EQ(jps, astar) << density;
  }
}

TEST(Jps, JumpsOnLargeMapsOfOtherKinds) {
  for (const GeneratorInfo& generator : generators()) {
    const GridMap map = *make_map(generator.name, 512, 512, 7);
    if (generator.name == "random" || !map.uniform_terrain()) continue;
    const auto [jps, astar] = expansions_of_jps_and_astar(map);
    EXPECT_LT(10 * jps, astar) << generator.name;
  }
  for (const char* const width : {"2", "3", "4"}) {
    const auto [jps, astar] =
        expansions_of_jps_and_astar(*make_map("maze", 512, 512, 7, {{"corridor_width", width}}));
    EXPECT_LT(10 * jps, astar) << "a maze of corridors of " << width;
  }
}

TEST(Jps, KeepsItsJumpsWhenAFewCellsOfALargeMapChange) {
  FreeSpace space = *make_free_space(*make_map("rooms", 512, 512, 7));
  const auto planner = *make_planner("jps", space);
  MapEdit edit;
  edit.cells.push_back({{3, 3}, CellState::occupied});
  planner->release();
  const SpaceChange change = *space.edit(edit);
  ASSERT_TRUE(planner->update(space, change));
  EXPECT_FALSE(PreparedJumps::of(space)->is_noise(space.passable()));
}

TEST(Jps, RefusesTerrainAndSaysSo) {
  const Grid<CellState> cells(5, 5, CellState::free);
  const auto planner =
      make_planner("jps", *make_free_space(*make_grid_map(cells, {}, Grid<double>(5, 5, 2.0))));
  ASSERT_FALSE(planner);
  EXPECT_EQ(planner.error().status, Status::unsupported_map);
  EXPECT_THAT(planner.error().message, ::testing::HasSubstr("terrain"));
}

TEST(Jps, TakesNoOptions) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(5, 5, CellState::free)));
  const auto planner = make_planner("jps", space, {{"weight", "2"}});
  ASSERT_FALSE(planner);
  EXPECT_EQ(planner.error().status, Status::invalid_option);
}

}  // namespace
}  // namespace wend
