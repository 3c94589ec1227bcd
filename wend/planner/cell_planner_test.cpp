#include "wend/planner/cell_planner.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <utility>

#include "tests/testing/drawn_map.hpp"
#include "wend/planner/observer.hpp"

namespace wend {
namespace {

constexpr GridMoves kOrthogonalSteps{Connectivity::four, CornerRule::none};

/// Goes to the right until it is at a goal or can go no farther.
class Rightwards final : public CellPlanner {
 public:
  explicit Rightwards(FreeSpace space) : CellPlanner(std::move(space), kOrthogonalSteps, 1) {}

 private:
  SearchOutcome search(CellSearch& search, Path& path) override {
    std::optional<Cell> parent;
    for (Cell cell = search.start(); free_space().passable(cell); ++cell.x) {
      search.generate(cell, parent, static_cast<double>(path.size()));
      if (!search.expand(cell, parent, static_cast<double>(path.size()))) return search.outcome();
      path.append(cell);
      if (search.is_goal(cell)) return SearchOutcome::found;
      parent = cell;
    }
    return SearchOutcome::exhausted;
  }

  std::unique_ptr<Planner> do_clone() const override {
    return std::make_unique<Rightwards>(free_space());
  }
};

std::string status_text(Planner& planner, const Query& query) {
  Plan plan;
  const Status status = planner.plan(query, plan);
  EXPECT_EQ(plan.path.empty(), status != Status::found);
  return std::string(to_string(status));
}

TEST(CellPlanner, ComputesCostBoundAndMetrics) {
  Rightwards planner(test::open_space(6, 3));
  const auto plan = planner.plan(Query::between({1, 1}, {5, 1}));
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->path.size(), 5U);
  EXPECT_EQ(plan->cost, 4);
  EXPECT_TRUE(plan->optimal());
  EXPECT_EQ(plan->metrics, (SearchMetrics{5, 5, 1}));
  EXPECT_EQ(planner.grid_moves(), kOrthogonalSteps);
}

TEST(CellPlanner, ChecksBothEndsAndSaysWhatIsThere) {
  Rightwards planner(test::drawn_space(R"(
..#.
..#.
)"));
  EXPECT_EQ(status_text(planner, Query::between({-1, 0}, {1, 0})), "start_outside");
  EXPECT_EQ(status_text(planner, Query::between({2, 0}, {1, 0})), "start_blocked");
  EXPECT_EQ(status_text(planner, Query::between({0, 0}, {2, 0})), "goal_blocked");
  EXPECT_EQ(status_text(planner, Query::between({0, 0}, {3, 0})), "unreachable");
  const auto failed = planner.plan(Query::between({0, 0}, {2, 0}));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "the goal, cell (2,0), is an obstacle");
}

TEST(CellPlanner, EndsTheSearchAtItsLimits) {
  Rightwards planner(test::open_space(10, 1));
  Query query = Query::between({0, 0}, {9, 0});
  query.limits.expansions = 3;
  EXPECT_EQ(status_text(planner, query), "expansion_limit");
  query.limits = {};
  const std::atomic<bool> cancel = true;
  query.limits.cancel = &cancel;
  EXPECT_EQ(status_text(planner, query), "cancelled");
  query.limits = {};
  query.limits.seconds = -1;
  EXPECT_EQ(status_text(planner, query), "time_limit");
}

TEST(CellPlanner, EndsWhereItFindsNothingMore) {
  Rightwards planner(test::open_space(4, 2));
  EXPECT_EQ(status_text(planner, Query::between({0, 0}, {3, 1})), "unreachable");
  Query query = Query::between({0, 0}, {3, 1});
  query.goals.emplace_back(pose_at(Cell{2, 0}));
  EXPECT_EQ(status_text(planner, query), "found") << "any of the goals";
}

TEST(CellPlanner, TellsAnObserver) {
  class Counts final : public SearchObserver {
   public:
    void on_generate(const SearchEvent&) override { ++generated; }
    void on_expand(const SearchEvent& event) override { last = event; }
    void on_relax(const SearchEvent&) override { FAIL(); }
    int generated = 0;
    SearchEvent last{};
  } counts;
  Rightwards planner(test::open_space(6, 1));
  Query query = Query::between({1, 0}, {4, 0});
  query.observer = &counts;
  EXPECT_EQ(status_text(planner, query), "found");
  EXPECT_EQ(counts.generated, 4);
  EXPECT_EQ(counts.last.cell, (Cell{4, 0}));
  EXPECT_EQ(counts.last.parent, (Cell{3, 0}));
  EXPECT_EQ(counts.last.g, 3);
}

TEST(CellPlanner, PlansOnAnotherSpaceAfterAnUpdateAndInAClone) {
  Rightwards planner(test::open_space(2, 1));
  ASSERT_TRUE(planner.update(test::open_space(8, 1)));
  EXPECT_EQ(status_text(planner, Query::between({0, 0}, {7, 0})), "found");
  EXPECT_EQ(status_text(*planner.clone(), Query::between({0, 0}, {7, 0})), "found");
}

}  // namespace
}  // namespace wend
