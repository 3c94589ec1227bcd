// Holds every planner of the registry to what it declares, with every check of the conformance suite. A new
// planner is tested by being listed.

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "conformance/suite.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr std::uint64_t kMaps = 600;
constexpr std::uint64_t kMapsOfDrives =
    150;  // hybrid_astar may search for seconds to know that there is no drive
constexpr std::uint64_t kMapsOfALongRun = 10000;

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const ConformanceCheck& check : conformance_checks()) names.push_back(check.name);
  return names;
}

class Conformance : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  static void expect_no_violation(std::uint64_t maps) {
    const auto& [planner, name] = GetParam();
    const ConformanceCheck& check = *find_check(name);
    const CheckReport report = run_check(check, *planners().find(planner), {.maps = maps});
    if (!report.not_applicable.empty()) GTEST_SKIP() << report.not_applicable;
    EXPECT_EQ(report.maps > 0, true);
    EXPECT_EQ(report.violations, 0U) << check.guarantee;
    if (!report.smallest) return;
    ADD_FAILURE() << "expected: " << report.smallest->expected
                  << "\ncame: " << report.smallest->came << "\nquery: " << report.smallest->query
                  << '\n'
                  << report.smallest->trial;
  }
};

/// Searches for poses take long under the sanitizer; for cells, few maps have too few paths to say anything.
TEST_P(Conformance, HoldsOnRandomMaps) {
  const PlannerInfo& planner = *planners().find(std::get<0>(GetParam()));
  const std::uint64_t maps = planner.name == "hybrid_astar" ? kMapsOfDrives : kMaps;
  expect_no_violation(planner.capabilities.headings ? share_of(maps) : maps);
}

std::string name_of(const ::testing::TestParamInfo<Conformance::ParamType>& test) {
  return std::get<0>(test.param) + "_" + std::get<1>(test.param);
}

INSTANTIATE_TEST_SUITE_P(Registry, Conformance,
                         ::testing::Combine(::testing::ValuesIn(planners().names()),
                                            ::testing::ValuesIn(check_names())),
                         name_of);

class ConformanceOfAnswers : public Conformance {};

TEST_P(ConformanceOfAnswers, HoldsOnManyRandomMapsInALongRun) {
  expect_no_violation(kMapsOfALongRun);
}

INSTANTIATE_TEST_SUITE_P(Registry, ConformanceOfAnswers,
                         ::testing::Combine(::testing::ValuesIn(planners().names()),
                                            ::testing::Values("answers", "poses")),
                         name_of);

}  // namespace
}  // namespace wend::test
