#pragma once

// anytime_work(): the work of an anytime planner until its path is proven to be optimal, beside that of A*.

#include <gtest/gtest.h>

#include <cmath>

#include "wend/planner/planner.hpp"

namespace wend::test {

/// The geometric mean of the expansions until the proof over those of `astar`, for this number of queries that have
/// a path. Expects equal costs. `next_query` makes the queries.
template <class NextQuery>
double anytime_work(Planner& planner, Planner& astar, int queries, NextQuery&& next_query) {
  constexpr double kRelative = 1e-9;
  double logarithms = 0;
  Plan plan;
  Plan expected;
  for (int found = 0; found < queries;) {
    const Query query = next_query();
    if (astar.plan(query, expected) != Status::found) continue;
    EXPECT_EQ(planner.plan(query, plan), Status::found);
    EXPECT_NEAR(plan.cost, expected.cost, kRelative * (1 + expected.cost));
    EXPECT_TRUE(plan.optimal());
    logarithms += std::log(static_cast<double>(plan.metrics.expanded) /
                           static_cast<double>(expected.metrics.expanded));
    ++found;
  }
  return std::exp(logarithms / queries);
}

}  // namespace wend::test
