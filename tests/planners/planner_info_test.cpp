// What every planner of the registry says of itself, whatever it moves, and the options it takes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "conformance/random_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

class EveryPlanner : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(GetParam()); }
};

TEST_P(EveryPlanner, TakesItsDefaultsAndRefusesWhatIsOutOfRange) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(3, 2, CellState::free)));
  std::set<std::string> names;
  for (const OptionInfo& option : info().options) {
    SCOPED_TRACE(option.name);
    EXPECT_NE(option.help, "");
    EXPECT_TRUE(names.insert(option.name).second) << "two options of one name";
    const auto made = make_planner(GetParam(), space, {{option.name, option.default_value}});
    EXPECT_TRUE(made) << made.error().message;
    for (const std::string& bad : bad_values(option)) {
      const auto refused = make_planner(GetParam(), space, {{option.name, bad}});
      ASSERT_FALSE(refused) << "it takes '" << bad << "'";
      EXPECT_EQ(to_string(refused.error().status), to_string(Status::invalid_option));
      EXPECT_THAT(refused.error().message, ::testing::HasSubstr(option.name));
    }
  }
  const auto unknown = make_planner(GetParam(), space, {{"no_such_option", "1"}});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(to_string(unknown.error().status), to_string(Status::invalid_option));
}

TEST_P(EveryPlanner, SaysWhatItIs) {
  EXPECT_NE(info().summary, "");
  EXPECT_NE(info().idea, "");
  EXPECT_NE(info().citation, "");
  EXPECT_NE(info().guarantee_text, "");
  EXPECT_NE(info().time, "");
  EXPECT_NE(info().memory, "");
  EXPECT_NE(info().when, "");
  EXPECT_EQ(info().summary.find('\n'), std::string::npos);
}

/// A bound that is guaranteed with consistent options is there with the defaults.
TEST_P(EveryPlanner, IsBoundedByDefaultIfItGuaranteesABound) {
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(3, 2, CellState::free)));
  const auto planner = make_planner(GetParam(), space);
  ASSERT_TRUE(planner);
  const auto plan = (*planner)->plan(Query::between({0, 0}, {0, 0}));
  ASSERT_TRUE(plan);
  const bool guaranteed = info().guarantee >= Guarantee::bounded;
  EXPECT_TRUE(!guaranteed || plan->bound < Plan::kNoBound);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryPlanner, ::testing::ValuesIn(planners().names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
