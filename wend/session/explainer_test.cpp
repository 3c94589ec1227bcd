#include "wend/session/explainer.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

std::string stopped(const Limits& limits, const Hints& hints) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(3, 3, CellState::free)));
  SearchMetrics metrics;
  metrics.expanded = 1000;
  return Explainer(space, Units(space.map()), {}, hints)
      .stopped(Status::expansion_limit, limits, metrics);
}

TEST(Explainer, NamesTheLimitOnExpansions) {
  Limits limits;
  limits.expansions = 1000;
  EXPECT_EQ(stopped(limits, {}), "stopped after 1000 expansions");
  EXPECT_EQ(stopped(limits, {.limit_expansions = "--limit"}),
            "stopped after 1000 expansions (--limit 1000)");
}

TEST(Explainer, TellsAPlannersOwnLimitFromThatOfAQuery) {
  EXPECT_EQ(stopped({}, {}),
            "stopped after 1000 expansions, the planner's own limit; give it a higher one");
  EXPECT_EQ(stopped({}, {.limit_expansions = "--limit"}),
            "stopped after 1000 expansions, the planner's own limit; give it a higher one "
            "(--limit 2000)");
}

}  // namespace
}  // namespace wend
