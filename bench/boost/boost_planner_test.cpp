// The yardstick answers like our own planners, also with several goals and tolerances.

#include "bench/boost/boost_planner.hpp"

#include <gtest/gtest.h>

#include <string>

#include "conformance/trial.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

TEST(BoostPlanner, AnswersLikeAStar) {
  int found = 0;
  int several = 0;
  for (std::uint64_t seed = 1; seed <= 400 && !::testing::Test::HasFailure(); ++seed) {
    const test::Trial trial = test::random_trial(seed, *planners().find("jps"));
    SCOPED_TRACE(text_of(trial, seed));
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    const auto boost = boost_astar_planner().make(space, {});
    ASSERT_EQ(boost.has_value(), space.uniform_terrain());
    if (!boost) continue;
    const auto astar = make_planner("astar", space);
    Random random(seed);
    for (int i = 0; i < 4; ++i) {
      const test::TestQuery asked = test::random_test_query(random, trial.map);
      SCOPED_TRACE(text_of(asked));
      Plan expected;
      Plan plan;
      const Status status = (*astar)->plan(asked.query(), expected);
      EXPECT_EQ(to_string((*boost)->plan(asked.query(), plan)), to_string(status));
      if (status != Status::found) continue;
      EXPECT_NEAR(plan.cost, expected.cost, 1e-4) << "Boost's costs are floats";
      ++found;
      several += asked.goals.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(several, 20);
}

}  // namespace
}  // namespace wend::bench
