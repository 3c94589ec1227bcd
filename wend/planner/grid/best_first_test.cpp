// The engines of dijkstra and astar: 32-bit costs and 64-bit ones are to give the same search, and
// paths too long for 32 bits the right answer.

#include "wend/planner/grid/best_first.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <numbers>
#include <string>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// Watches: that takes the engine with 64-bit costs.
class IdleObserver final : public SearchObserver {
 public:
  void on_generate(const SearchEvent&) override {}
  void on_expand(const SearchEvent&) override { ++expanded; }
  void on_relax(const SearchEvent&) override {}
  std::uint64_t expanded = 0;
};

std::unique_ptr<Planner> make(std::string_view name, const FreeSpace& space,
                              const OptionValues& options = {}) {
  return std::move(make_planner(name, space, options).value());
}

class BestFirstPlanner : public ::testing::TestWithParam<std::string> {};

TEST_P(BestFirstPlanner, SearchesTheSameWithCompactAndWithWideCosts) {
  constexpr std::array kConnectivities{"4", "8"};
  constexpr std::array kCornerRules{"none", "one", "both"};
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    const int width = random.between(20, 60);
    const int height = random.between(20, 60);
    const FreeSpace space =
        *make_free_space(*make_grid_map(test::random_states(random, width, height)));
    const OptionValues options{{"connectivity", kConnectivities[random.below(2)]},
                               {"corner_rule", kCornerRules[random.below(3)]}};
    const auto compact_planner = make(GetParam(), space, options);
    const auto wide_planner = make(GetParam(), space, options);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(space.map()));
    for (int i = 0; i < 4; ++i) {
      Query query{pose_at(test::random_cell(random, width, height)), {}};
      for (int goals = random.between(1, 3); goals > 0; --goals) {
        query.goals.push_back(pose_at(test::random_cell(random, width, height)));
      }
      Plan compact;
      const Status status = compact_planner->plan(query, compact);
      IdleObserver idle_observer;
      query.observer = &idle_observer;
      Plan wide;
      ASSERT_EQ(wide_planner->plan(query, wide), status);
      EXPECT_EQ(wide.metrics, compact.metrics);
      EXPECT_EQ(wide.path, compact.path);
      EXPECT_EQ(wide.cost, compact.cost);
      EXPECT_EQ(idle_observer.expanded, compact.metrics.expanded);
    }
  }
}

/// Corridors back and forth: a path of some 200 000 cells, which 32-bit costs cannot hold.
class Serpentine {
 public:
  static constexpr int kWidth = 801;
  static constexpr int kCorridors = 250;

  Serpentine() : space_(*make_free_space(*make_grid_map(states()))) {}

  const FreeSpace& space() const { return space_; }

  /// The cell `steps` steps from (0, 0). A corridor takes kWidth cells, the way to the next one 2
  /// steps.
  static Cell cell_at(int steps) {
    const int corridor = steps / (kWidth + 1);
    const int along = steps % (kWidth + 1);
    const bool to_the_right = corridor % 2 == 0;
    if (along == kWidth) return {to_the_right ? kWidth - 1 : 0, 2 * corridor + 1};
    return {to_the_right ? along : kWidth - 1 - along, 2 * corridor};
  }

 private:
  static Grid<CellState> states() {
    Grid<CellState> states(kWidth, 2 * kCorridors - 1, CellState::free);
    for (int y = 1; y < states.height(); y += 2) {
      const int gap = y % 4 == 1 ? kWidth - 1 : 0;
      for (int x = 0; x < kWidth; ++x) {
        if (x != gap) states[{x, y}] = CellState::occupied;
      }
    }
    return states;
  }

  FreeSpace space_;
};

TEST_P(BestFirstPlanner, FindsPathsThatOutgrow32BitCosts) {
  const Serpentine serpentine;
  // 32 bits hold 128 356 straight steps; the search changes over a little before.
  for (const int steps : {1000, 126'000, 128'356, 128'357, 128'400, 199'999}) {
    SCOPED_TRACE(steps);
    const auto planner = make(GetParam(), serpentine.space());
    for (const int then : {steps, 7, steps}) {
      const auto plan = planner->plan(Query::between({0, 0}, Serpentine::cell_at(then)));
      ASSERT_TRUE(plan);
      EXPECT_EQ(plan->cost, then);
      EXPECT_EQ(plan->path.size(), static_cast<std::size_t>(then) + 1);
      EXPECT_EQ(plan->metrics.expanded, plan->path.size()) << "of the search that answered";
    }
  }
}

TEST_P(BestFirstPlanner, StepsAndStopsAcrossTheChangeToWideCosts) {
  const Serpentine serpentine;
  Query query = Query::between({0, 0}, Serpentine::cell_at(150'000));
  Plan plan;
  query.limits.expansions = 140'000;
  EXPECT_EQ(make(GetParam(), serpentine.space())->plan(query, plan), Status::expansion_limit);
  EXPECT_EQ(plan.metrics.expanded, 140'000U);

  query.limits.expansions = Limits::kUnlimited;
  const auto planner = make(GetParam(), serpentine.space());
  auto outcome = planner->begin(query, plan);
  while (!outcome) outcome = planner->step(plan);
  EXPECT_EQ(*outcome, Status::found);
  EXPECT_EQ(plan.cost, 150'000);
}

/// The time of both searches counts. The clock goes on by 1 with each of its readings, of which
/// there is one in 256 expansions: some 490 before the change, and 580 after it.
TEST_P(BestFirstPlanner, HasNoMoreTimeForChangingToWideCosts) {
  const Serpentine serpentine;
  Query query = Query::between({0, 0}, Serpentine::cell_at(150'000));
  double now = 0;
  query.limits.clock = [&] { return now++; };
  Plan plan;
  query.limits.seconds = 800;
  EXPECT_EQ(make(GetParam(), serpentine.space())->plan(query, plan), Status::time_limit);
  query.limits.seconds = 1200;
  EXPECT_EQ(make(GetParam(), serpentine.space())->plan(query, plan), Status::found);
}

TEST_P(BestFirstPlanner, PlansOnMapsWhereEvenEstimatesOutgrow32Bits) {
  const auto planner = make(GetParam(), test::open_space(23'000, 2));
  const auto plan = planner->plan(Query::between({0, 0}, {22'999, 1}));
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->cost, 22'998 + std::numbers::sqrt2, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Registry, BestFirstPlanner, ::testing::Values("dijkstra", "astar"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend
