// After edits of its space in place, jps answers like one that is made for the edited space.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

/// A space with planners on it that live through its edits.
class EditedSpace {
 public:
  explicit EditedSpace(GridMap map) : space_(*make_free_space(std::move(map))) {
    planners_.push_back(*make_planner("jps", space_));
  }

  const FreeSpace& space() const { return space_; }
  Planner& planner(std::size_t i) { return *planners_[i % planners_.size()]; }

  void add_clone() { planners_.push_back(planners_.front()->clone()); }

  /// Edits the space in place. `kept`: a planner keeps the space as it was meanwhile, so that the edit copies it.
  void edit(const MapEdit& edit, bool kept) {
    for (const auto& planner : planners_) {
      if (!kept) planner->release();
    }
    const auto change = space_.edit(edit);
    ASSERT_TRUE(change) << change.error().message;
    for (const auto& planner : planners_) ASSERT_TRUE(planner->update(space_, *change));
  }

 private:
  FreeSpace space_;
  std::vector<std::unique_ptr<Planner>> planners_;
};

MapEdit toggle_cells(Random& random, const GridMap& map) {
  const int side = random.chance(0.8) ? 1 : random.between(2, 5);
  const int x = random.between(0, map.width() - 1);
  const int y = random.between(0, map.height() - 1);
  MapEdit edit{
      .corner = {x, y},
      .states = Grid<CellState>(std::min(side, map.width() - x), std::min(side, map.height() - y))};
  for (const Cell cell : every_cell(edit.states)) {
    const bool was_free = map.state({x + cell.x, y + cell.y}) == CellState::free;
    edit.states[cell] = was_free ? CellState::occupied : CellState::free;
  }
  return edit;
}

/// Asks a planner and a new one on the same map, which shares nothing with it. Returns how many paths there were.
std::size_t expect_equal_answers(EditedSpace& edited, Random& random, int queries) {
  const FreeSpace apart = *make_free_space(edited.space().map());
  const auto fresh = *make_planner("jps", apart);
  const auto astar = *make_planner("astar", apart);
  std::size_t found = 0;
  for (int i = 0; i < queries; ++i) {
    const Cell start = test::random_cell(random, apart.width(), apart.height());
    const Cell goal = test::random_cell(random, apart.width(), apart.height());
    const Query query = Query::between(start, goal);
    Plan plan;
    Plan expected;
    Plan cheapest;
    const Status status = edited.planner(static_cast<std::size_t>(i)).plan(query, plan);
    EXPECT_EQ(status, fresh->plan(query, expected)) << "query " << i;
    EXPECT_EQ(status, astar->plan(query, cheapest)) << "query " << i;
    if (status != Status::found) continue;
    ++found;
    EXPECT_EQ(plan.path, expected.path) << "query " << i;
    EXPECT_EQ(plan.cost, expected.cost) << "query " << i;
    EXPECT_NEAR(plan.cost, cheapest.cost, 1e-9) << "query " << i;
  }
  return found;
}

/// Most maps are so small that the planner has prepared them after some queries.
void edit_and_compare(std::uint64_t seed, int maps) {
  Random random(seed);
  std::size_t found = 0;
  for (int i = 0; i < maps; ++i) {
    const int width = random.between(1, i % 5 == 0 ? 90 : 24);
    const int height = random.between(1, 24);
    EditedSpace edited(*make_grid_map(test::random_states(random, width, height)));
    for (int edit = 0; edit < 12; ++edit) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", map " + std::to_string(i) + ", edit " +
                   std::to_string(edit));
      found += expect_equal_answers(edited, random, random.chance(0.3) ? 40 : 6);
      if (random.chance(0.1)) edited.add_clone();
      edited.edit(toggle_cells(random, edited.space().map()), random.chance(0.1));
      if (random.chance(0.2)) {
        edited.edit(toggle_cells(random, edited.space().map()), false);  // two at once
      }
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(found, 10U * static_cast<std::size_t>(maps)) << "or it proves little";
}

TEST(JpsEdits, AnswersEqualThoseOfANewPlannerOnTheEditedMap) {
  edit_and_compare(51, test::share_of(150));
}

TEST(JpsEdits, AnswersEqualThoseOfANewPlannerOnTheEditedMapLongRun) { edit_and_compare(52, 10000); }

/// The states that a new planner expands.
std::uint64_t expanded_by_new_planner(const FreeSpace& space, const Query& query) {
  const auto plan = (*make_planner("jps", space))->plan(query);
  EXPECT_TRUE(plan);
  return plan ? plan->metrics.expanded : 0;
}

/// A search expands fewer states on a map that is prepared, because it skips dead ends.
TEST(JpsEdits, ANewPlannerFindsWhatOthersHavePreparedOfTheSpace) {
  FreeSpace space = *make_free_space(*make_map("maze", 101, 101, 3));
  const Query query = Query::between({1, 1}, {99, 99});
  const std::uint64_t unprepared = expanded_by_new_planner(space, query);
  for (int i = 0; i < 300; ++i) expanded_by_new_planner(space, query);
  const std::uint64_t prepared = expanded_by_new_planner(space, query);
  EXPECT_LT(prepared, unprepared);
  ASSERT_TRUE(space.edit({.cells = {{{50, 0}, CellState::free}}}));
  EXPECT_LT(expanded_by_new_planner(space, query), unprepared) << "repaired";
  FreeSpace copy = space;
  ASSERT_TRUE(copy.edit({.cells = {{{50, 0}, CellState::occupied}}}));
  EXPECT_EQ(expanded_by_new_planner(copy, query), unprepared) << "nothing is known of a copy";
  EXPECT_LT(expanded_by_new_planner(space, query), unprepared) << "the original keeps it";
}

}  // namespace
}  // namespace wend
