// `wend explain --planner hybrid_astar`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A yard above a pocket, in which a long robot has no room sideways.
constexpr const char* kPocketFile =
    "##############\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "#............#\n"
    "####...#######\n"
    "####...#######\n"
    "####...#######\n"
    "##############\n";

class ExplainDrive : public testing::Test {
 protected:
  Outcome explain(std::vector<std::string> more) const {
    more.insert(more.begin(), {"explain", pocket_, "--planner", "hybrid_astar"});
    return wend(std::move(more));
  }
  Outcome plan(std::vector<std::string> more) const {
    more.insert(more.begin(), {"plan", pocket_, "--planner", "hybrid_astar"});
    return wend(std::move(more));
  }

  TemporaryFolder folder_;
  std::string pocket_ = folder_.write("pocket.txt", kPocketFile);
  std::vector<std::string> sideways_{"--start",          "3,2,E",
                                     "--goal",           "5,7,E",
                                     "--footprint",      "1.4,0.7; 1.4,-0.7; -2.4,-0.7; -2.4,0.7",
                                     "--turning-radius", "3"};
};

TEST_F(ExplainDrive, NamesTheCornerThatTouches) {
  const Outcome outcome = explain(sideways_);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("there is no drive from start (3,2,E) to goal (5,7,E)\n"),
                    HasSubstr("the goal ("), HasSubstr("rear right"),
                    HasSubstr("lies in the obstacle cell (3,8)"),
                    HasSubstr("would help        a footprint of at most")));
}

TEST_F(ExplainDrive, SaysWhatHelpsAndItHelps) {
  const std::vector<std::string> facing_the_end{"--start",
                                                "5,7,S",
                                                "--goal",
                                                "9,3,E",
                                                "--footprint",
                                                "0.9,0.9; 0.9,-0.9; -0.9,-0.9; -0.9,0.9",
                                                "--turning-radius",
                                                "3",
                                                "--no-allow-reverse"};
  const Outcome outcome = explain(facing_the_end);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("found no drive"), HasSubstr("the start (5.5,7.5,S)"),
                    HasSubstr("would help        driving in reverse (--allow-reverse)")));
  std::vector<std::string> in_reverse = facing_the_end;
  in_reverse.back() = "--allow-reverse";
  EXPECT_EQ(plan(facing_the_end).code, 1);
  EXPECT_EQ(plan(in_reverse).code, 0);
  const Outcome there_is = explain(in_reverse);
  EXPECT_EQ(there_is.code, 0);
  EXPECT_THAT(there_is.out, StartsWith("there is a drive from start (5,7,S) to goal (9,3,E)\n"));
}

TEST_F(ExplainDrive, TellsProgramsToo) {
  std::vector<std::string> asked = sideways_;
  asked.insert(asked.end(), {"--format", "json", "-o", folder_ / "why.png"});
  const Outcome outcome = explain(asked);
  EXPECT_THAT(outcome.out, StartsWith(R"({"schema":1,"status":"goal_blocked",)"));
  const json why = json::parse(outcome.out);
  EXPECT_GT(why.at("footprint_scale"), 0.2);
  EXPECT_LE(why.at("footprint_scale"), 1.5 / 2.4);  // as long as the pocket is wide
  EXPECT_TRUE(why.at("turning_radius_cells").is_null());
  EXPECT_TRUE(why.at("reverse_helps").is_null());
  EXPECT_EQ(why.at("inscribed_radius_cells"), 0.7);
  EXPECT_FALSE(bytes_of(folder_ / "why.png").empty());
}

TEST_F(ExplainDrive, RefusesWhatChangesNothing) {
  const std::vector<std::string> ends{"--start", "3,2,E", "--goal", "5,7,E"};
  const auto refused = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"explain", pocket_});
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    const Outcome outcome = wend(arguments);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused({"--turning-radius", "2"}), HasSubstr("it needs --planner hybrid_astar"));
  EXPECT_THAT(refused({"--no-allow-reverse"}), HasSubstr("it needs --planner hybrid_astar"));
  EXPECT_THAT(refused({"--planner", "hybrid_astar", "--connectivity", "4"}),
              HasSubstr("has no moves between cells"));
  EXPECT_THAT(refused({"--planner", "car"}), HasSubstr("explain takes hybrid_astar"));
  EXPECT_THAT(refused({"--planner", "hybrid_astar", "--turning-radius", "0"}),
              HasSubstr("a car needs a turning_radius greater than 0"));
}

}  // namespace
}  // namespace wend::test
