// When planners on cells ask which cells are connected: only once a search has taken about as long as finding out.

#include "wend/planner/grid/grid_planner.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

FreeSpace space_of(const GridMap& map) { return *make_free_space(map); }

/// A room of this size; a wall closes off a chamber around the cell (size - 3, size - 3).
GridMap room_with_chamber(int size) {
  Grid<CellState> cells(size, size, CellState::free);
  for (int i = size - 5; i < size; ++i) {
    cells[{i, size - 5}] = CellState::occupied;
    cells[{size - 5, i}] = CellState::occupied;
  }
  return *make_grid_map(cells);
}

/// The planners that search cells and remember nothing.
std::vector<std::string> searching_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    const Capabilities& can = info.capabilities;
    const bool searches = can.can_step && !can.headings && !can.resumes;
    if (searches && info.name != "random_walk") names.push_back(info.name);
  }
  return names;
}

/// Counts how often a search looks at its clock before the components are known: every 256 expansions.
struct Looks {
  const FreeSpace& space;
  int count = 0;

  Clock clock() {
    return [this] {
      count += space.knows_components() ? 0 : 1;
      return 0.0;
    };
  }
};

class FirstQuery : public ::testing::TestWithParam<std::string> {
 protected:
  static std::unique_ptr<Planner> planner_on(const FreeSpace& space) {
    return *make_planner(GetParam(), space);
  }
};

TEST_P(FirstQuery, ThatIsShortDoesNotAskForComponents) {
  if (GetParam() == "dfs") GTEST_SKIP() << "it goes astray";
  const FreeSpace space = space_of(room_with_chamber(300));
  Plan plan;
  ASSERT_EQ(planner_on(space)->plan(Query::between({10, 10}, {13, 12}), plan), Status::found);
  EXPECT_FALSE(space.knows_components());
}

TEST_P(FirstQuery, WithoutAPathAsksBeforeItHasSearchedMuch) {
  for (const bool reversed : {false, true}) {  // the chamber is soon exhausted
    const FreeSpace space = space_of(room_with_chamber(600));
    const auto planner = planner_on(space);
    Looks looks{space};
    Query query = Query::between({3, 3}, {597, 597});
    if (reversed) query = Query::between({597, 597}, {3, 3});
    query.limits.clock = looks.clock();
    Plan plan;
    EXPECT_EQ(planner->plan(query, plan), Status::unreachable);
    EXPECT_EQ(plan.metrics.expanded, 0U) << "as if nothing had been searched";
    EXPECT_TRUE(space.knows_components());
    constexpr int kLooksOfLabelling = 2 * 10 * 10 + 6;  // two for each tile of 64 x 64 cells
    EXPECT_LE(looks.count, 600 * 600 / 64 / 256 + kLooksOfLabelling);
  }
}

TEST_P(FirstQuery, IsAnsweredAsTheNextOnes) {
  Random random(11);
  for (int round = 0; round < 150; ++round) {
    const GridMap map = test::random_map(random);
    const FreeSpace fresh = space_of(map);
    const FreeSpace known = space_of(map);
    known.components();
    const auto planner = make_planner(GetParam(), fresh);
    if (!planner) continue;  // it refuses terrain
    const auto cell = [&] {
      return Cell{static_cast<int>(random.below(static_cast<std::uint64_t>(map.width()))),
                  static_cast<int>(random.below(static_cast<std::uint64_t>(map.height())))};
    };
    Query query = Query::between(cell(), cell());
    if (random.chance(0.3)) query.limits.expansions = random.below(20);
    if (random.chance(0.2)) query.goals.push_back(Goal{centre_of(cell())});
    Plan first;
    Plan next;
    ASSERT_EQ((*planner)->plan(query, first), planner_on(known)->plan(query, next));
    ASSERT_EQ(first.path, next.path);
    ASSERT_EQ(first.cost, next.cost);
    ASSERT_EQ(first.metrics.expanded, next.metrics.expanded);
    ASSERT_EQ(first.metrics.generated, next.metrics.generated);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, FirstQuery, ::testing::ValuesIn(searching_planners()),
                         [](const auto& test) { return test.param; });

TEST(FirstQueryLimits, EndAlsoTheLabellingOfComponents) {
  const FreeSpace space = space_of(room_with_chamber(2000));
  const auto planner = *make_planner("astar", space);
  Query query = Query::between({3, 3}, {1997, 1997});
  double now = 0;
  query.limits.seconds = 1;
  query.limits.clock = [&now] { return now += 0.1; };
  Plan plan;
  EXPECT_EQ(planner->plan(query, plan), Status::time_limit);
  EXPECT_FALSE(space.knows_components());
  EXPECT_GT(plan.metrics.expanded, 0U);
}

TEST(FirstQueryInSteps, AsksFirst) {
  const FreeSpace space = space_of(room_with_chamber(40));
  const auto planner = *make_planner("astar", space);
  Plan plan;
  EXPECT_EQ(planner->begin(Query::between({3, 3}, {37, 37}), plan), Status::unreachable);
  EXPECT_EQ(planner->begin(Query::between({3, 3}, {9, 9}), plan), std::nullopt);
}

}  // namespace
}  // namespace wend
