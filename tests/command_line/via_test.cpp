// --via, --closed and --stop of plan and compare.

#include <gmock/gmock.h>

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kRoom =
    "............\n"
    "............\n"
    "............\n"
    "............\n"
    "############\n"
    "............\n";

class Vias : public testing::Test {
 protected:
  void SetUp() override { folder_.write("room.txt", kRoom); }

  std::string file(const std::string& name) const { return folder_ / name; }

  Outcome run(const std::string& command, const std::vector<std::string>& flags) const {
    std::vector<std::string> words{command, file("room.txt")};
    words.insert(words.end(), flags.begin(), flags.end());
    return wend(words);
  }

  TemporaryFolder folder_;
};

TEST_F(Vias, GiveALegEach) {
  const std::vector<std::string> ends{"--start", "1,1", "--via",  "9,1",
                                      "--via",   "9,3", "--goal", "1,3"};
  std::vector<std::string> flags = ends;
  flags.insert(flags.end(), {"--format", "json", "--smooth", "-o", file("path.csv")});
  const Outcome outcome = run("plan", flags);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json plan = json::parse(outcome.out);
  const json& legs = plan["legs"];
  ASSERT_EQ(legs.size(), 3U);
  EXPECT_EQ(legs[0]["from"], "start");
  EXPECT_EQ(legs[1]["from"], "via 1");
  EXPECT_EQ(legs[1]["to"], "via 2");
  EXPECT_EQ(legs[2]["to"], "goal");
  EXPECT_EQ(
      legs[0]["cost"].get<double>() + legs[1]["cost"].get<double>() + legs[2]["cost"].get<double>(),
      plan["cost"].get<double>());
  EXPECT_EQ(plan["path"][legs[1]["first"].get<std::size_t>()], json({9, 1}));
  EXPECT_EQ(plan["path"][legs[1]["last"].get<std::size_t>()], json({9, 3}));
  EXPECT_EQ(plan["path_smoothed"][plan["joins"][0].get<std::size_t>()], json({9.5, 1.5}));
  EXPECT_EQ(plan["bound"], 1);
  EXPECT_EQ(run("check", {file("path.csv")}).code, 0);
  const Outcome text = run("plan", ends);
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("legs      start to via 1: cost 8, 8 cells"),
                    HasSubstr("\n          via 1 to via 2: cost 2, 2 cells"), HasSubstr("V via")));
}

TEST_F(Vias, MayLeadBack) {
  const Outcome outcome = run("plan", {"--start", "1,1", "--via", "9,1", "--via", "9,3", "--closed",
                                       "--format", "json", "-o", file("loop.png")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json plan = json::parse(outcome.out);
  EXPECT_EQ(plan["path"].front(), plan["path"].back());
  EXPECT_EQ(plan["legs"].back()["to"], "start");
}

TEST_F(Vias, NameTheLegThatFails) {
  const Outcome outcome = run("plan", {"--start", "1,1", "--via", "9,1", "--via", "9,5", "--goal",
                                       "1,3", "--format", "json", "-o", file("why.png")});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("leg 2 of 3, from via 1 to via 2: there is no path"));
  const json plan = json::parse(outcome.out);
  ASSERT_EQ(plan["legs"].size(), 2U);
  EXPECT_EQ(plan["legs"][1]["status"], "unreachable");
  EXPECT_TRUE(plan["legs"][1]["cost"].is_null());
}

TEST_F(Vias, AreForPlannersWithHeadingsToo) {
  const Outcome outcome = run("plan", {"--planner", "car", "--start", "1,1,E", "--via", "5,2",
                                       "--goal", "10,1,E", "--format", "json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json plan = json::parse(outcome.out);
  EXPECT_EQ(plan["moves"].size() + 1, plan["path"].size());
  EXPECT_TRUE(plan["bound"].is_null());
  EXPECT_THAT(run("plan", {"--start", "1,1", "--via", "5,2,E", "--goal", "10,1"}).err,
              HasSubstr("--via: '5,2,E' has a heading"));
}

TEST_F(Vias, AreStopsOfTheTrajectoryIfThatIsAsked) {
  const auto seconds = [&](const std::vector<std::string>& more) {
    std::vector<std::string> flags{"--start", "1,1",          "--via",       "5,1",      "--goal",
                                   "10,1",    "--trajectory", file("t.csv"), "--format", "json"};
    flags.insert(flags.end(), more.begin(), more.end());
    const Outcome outcome = run("plan", flags);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["trajectory"]["duration_s"].get<double>();
  };
  EXPECT_GT(seconds({"--stop"}), seconds({}));
}

TEST_F(Vias, AreRefusedWhereTheyDoNotBelong) {
  struct Case {
    std::vector<std::string> flags;
    std::string message;
  };
  for (const Case& wrong : {
           Case{{"--closed", "--goal", "3,3"}, "leave out --goal"},
           Case{{"--closed"}, "add --via X,Y"},
           Case{{"--via", "x", "--goal", "3,3"}, "--via: 'x' is not X,Y"},
           Case{{"--via", "nan,1", "--goal", "3,3"}, "--via: 'nan,1' is not X,Y"},
           Case{{"--via", "3,1", "--goal", "3,3", "--stop"}, "--stop changes nothing"},
           Case{{"--via", "3,1", "--goal", "3,3", "--step"},
                "--step cannot be combined with --via"},
           Case{{"--via", "3,1", "--goal", "3,3", "--show", "expansion"}, "a search for each leg"},
           Case{{"--via", "3,1", "--goal", "3,3", "-o", "a.gif"}, "shows one search"},
       }) {
    std::vector<std::string> flags{"--start", "1,1"};
    flags.insert(flags.end(), wrong.flags.begin(), wrong.flags.end());
    const Outcome outcome = run("plan", flags);
    EXPECT_EQ(outcome.code, 2) << wrong.message;
    EXPECT_THAT(outcome.err, HasSubstr(wrong.message));
  }
}

TEST_F(Vias, AreComparedAsASum) {
  const Outcome outcome =
      run("compare", {"--start", "1,1", "--via", "9,1", "--via", "9,3", "--closed", "--planner",
                      "astar,jps", "--format", "json", "-o", file("both.png")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json query = json::parse(outcome.out)["queries"][0];
  EXPECT_EQ(query["vias"].size(), 2U);
  EXPECT_EQ(query["closed"], true);
  for (const json& row : query["planners"]) {
    EXPECT_NEAR(row["cost"].get<double>(), 8 + 2 + 6 + 2 * std::sqrt(2.0), 1e-9);
  }
  const Outcome failed = run("compare", {"--start", "1,1", "--via", "9,5", "--goal", "1,3",
                                         "--planner", "astar", "--format", "json"});
  EXPECT_EQ(failed.code, 1);
  EXPECT_THAT(json::parse(failed.out)["queries"][0]["planners"][0]["reason"].get<std::string>(),
              HasSubstr("leg 1 of 2, from the start to via 1: "));
}

}  // namespace
}  // namespace wend::test
