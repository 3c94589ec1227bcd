// Dynamic scenarios against a planner that follows their changes.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/testing/build_paths.hpp"
#include "wend/io/query/dynamic_scenario.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {
namespace {

/// The competition's file: every length is that of a shortest path on the map as it is then.
TEST(DynamicScenario, HasTrueLengths) {
  const auto file = test::data_folder() / "dynamic" / "dao_arena2.scen";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const auto scenario = load_dynamic_scenario(file);
  ASSERT_TRUE(scenario) << scenario.error().message;
  FreeSpace space = *make_free_space(
      *make_grid_map(Grid<CellState>(scenario->width, scenario->height, CellState::free)));
  const auto planner = *make_planner("jps", space);
  int queries = 0;
  int edits = 0;
  for (const auto& command : scenario->commands) {
    if (const auto* patch = std::get_if<PatchCommand>(&command)) {
      planner->release();
      const auto change = space.edit(scenario->edit_of(*patch));
      ASSERT_TRUE(change);
      ASSERT_TRUE(planner->update(space, *change));
      ++edits;
      continue;
    }
    const auto& query = std::get<ScenarioQuery>(command);
    const auto plan = planner->plan(Query::between(query.start, query.goal));
    ASSERT_EQ(plan.has_value(), !query.says_no_path()) << "line " << query.line;
    ASSERT_TRUE(!plan || length_matches(query, plan->cost)) << "line " << query.line;
    ++queries;
  }
  EXPECT_EQ(queries, 2000);
  EXPECT_EQ(edits, 439);
}

}  // namespace
}  // namespace wend
