#include "wend/planner/cell_planner.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

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
  std::optional<Cell> search(CellSearch& search) override {
    for (Cell cell = search.start(); search.expand(cell);) {
      if (search.is_goal(cell)) return cell;
      const Cell next{cell.x + 1, cell.y};
      if (!free_space().passable(next)) return std::nullopt;
      search.reach(next, cell, search.cost(cell) + 1);
      cell = next;
    }
    return std::nullopt;
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
  EXPECT_EQ(failed.error().message, describe(Status::goal_blocked));
  ASSERT_EQ(failed.error().failure.causes.size(), 1U);
  const auto* const blocked = std::get_if<EndBlocked>(&failed.error().failure.causes.front());
  ASSERT_NE(blocked, nullptr);
  EXPECT_EQ(blocked->end, EndIndex(0));
  EXPECT_EQ(blocked->cell, (Cell{2, 0}));
  EXPECT_EQ(blocked->reason, BlockReason::obstacle);
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

/// Reaches the cells to the right and below, each first through the cell above it, then more cheaply.
class Relaxing final : public CellPlanner {
 public:
  explicit Relaxing(FreeSpace space) : CellPlanner(std::move(space), kOrthogonalSteps) {}

 private:
  std::optional<Cell> search(CellSearch& search) override {
    const Cell start = search.start();
    const Cell right{start.x + 1, start.y};
    const Cell below{start.x, start.y + 1};
    const Cell goal{right.x, below.y};
    if (!search.expand(start)) return std::nullopt;
    search.reach(right, start, 1);
    search.reach(below, start, 1);
    EXPECT_FALSE(search.reached(goal));
    search.reach(goal, right, 9);
    search.reach(goal, below, 2);
    EXPECT_TRUE(search.reached(goal));
    EXPECT_EQ(search.cost(goal), 2);
    EXPECT_EQ(search.parent(goal), below);
    EXPECT_EQ(search.parent(start), std::nullopt);
    return goal;
  }

  std::unique_ptr<Planner> do_clone() const override {
    return std::make_unique<Relaxing>(free_space());
  }
};

TEST(CellPlanner, ThePathLeadsThroughTheLastParents) {
  class Relaxes final : public SearchObserver {
   public:
    void on_generate(const SearchEvent&) override {}
    void on_expand(const SearchEvent&) override {}
    void on_relax(const SearchEvent& event) override { events.push_back(event); }
    std::vector<SearchEvent> events;
  } relaxes;
  Relaxing planner(test::open_space(4, 4));
  Query query = Query::between({1, 1}, {2, 2});
  query.observer = &relaxes;
  for (int search = 1; search <= 3; ++search) {
    const auto plan = planner.plan(query);
    ASSERT_TRUE(plan);
    const std::vector<Cell> cells(plan->path.cells().begin(), plan->path.cells().end());
    EXPECT_EQ(cells, (std::vector<Cell>{{1, 1}, {1, 2}, {2, 2}}));
    EXPECT_EQ(plan->metrics, (SearchMetrics{1, 4, 3}));
    EXPECT_EQ(relaxes.events.size(), static_cast<std::size_t>(search));
    EXPECT_EQ(relaxes.events.back().cell, (Cell{2, 2}));
    EXPECT_EQ(relaxes.events.back().parent, (Cell{1, 2}));
  }
}

}  // namespace
}  // namespace wend
