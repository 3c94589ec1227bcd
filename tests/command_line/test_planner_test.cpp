// `wend test-planner`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(TestPlannerCommand, ShowsALineOfEveryCheckAndWhetherItPassed) {
  const Outcome outcome = wend({"test-planner", "bfs", "--maps", "12"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("answers         answers agree with the reference"),
                    HasSubstr("passed (12 maps, 48 queries)\n"),
                    HasSubstr("not applicable: for planners with headings\n"),
                    HasSubstr("bfs passed all 13 checks\n"), Not(HasSubstr("FAILED"))));
}

TEST(TestPlannerCommand, WalksPlannersWithHeadings) {
  for (const std::string planner : {"car", "lattice"}) {
    const Outcome outcome = wend({"test-planner", planner, "--maps", "12"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_THAT(outcome.out, HasSubstr("not applicable: for planners on cells\n"));
    EXPECT_THAT(outcome.out, HasSubstr(planner + " passed all 8 checks\n"));
  }
}

TEST(TestPlannerCommand, WritesJson) {
  const Outcome outcome =
      wend({"test-planner", "astar:weight=2", "--maps", "6", "--seed", "9", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("planner"), "astar:weight=2");
  EXPECT_EQ(json.at("guarantee"), "bounded");
  EXPECT_EQ(json.at("passed"), true);
  const auto& first = json.at("checks").at(0);
  EXPECT_EQ(first.at("name"), "answers");
  EXPECT_EQ(first.at("outcome"), "passed");
  EXPECT_EQ(first.at("maps"), 6);
  EXPECT_EQ(first.at("queries"), 24);
  EXPECT_EQ(json.at("checks").at(2).at("outcome"), "not applicable");
}

TEST(TestPlannerCommand, RefusesWhatIsNotOnePlannerWithItsOptions) {
  for (const std::string planner : {"astr", "astar,bfs", "astar:weight=x", "bfs:speed=1"}) {
    const Outcome outcome = wend({"test-planner", planner});
    EXPECT_EQ(outcome.code, 2) << planner;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, Not(IsEmpty()));
  }
  EXPECT_EQ(wend({"test-planner"}).code, 2);
  EXPECT_EQ(wend({"test-planner", "bfs", "--maps", "0"}).code, 2);
}

}  // namespace
}  // namespace wend::test
