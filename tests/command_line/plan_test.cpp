// `wend plan` and `wend field` on small maps, from outside.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// Two components: the right column is walled off.
constexpr const char* kPlannedGrid =
    ".....#.\n"
    ".###.#.\n"
    "....##.\n"
    ".~3..#?\n";

class PlanCommand : public testing::Test {
 protected:
  Outcome plan(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"plan", map_});
    return wend(std::move(arguments));
  }

  Outcome plan(const std::string& start, const std::string& goal,
               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"--start", start, "--goal", goal};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return plan(std::move(arguments));
  }

  json plan_json(const std::string& start, const std::string& goal,
                 std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--format", "json"});
    return json::parse(plan(start, goal, more).out);
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kPlannedGrid);
};

TEST_F(PlanCommand, ShowsThePathAndTheMapWithArrows) {
  const Outcome outcome = plan("0,0", "4,3");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, StartsWith("(0,0)>(0,1)>(0,2)>(1,2)>(2,2)>(3,3)>(4,3)\n"
                                      "S....#.\n"
                                      "↓###.#.\n"
                                      "→→↘.##.\n"
                                      ".~3→G#?\n"));
  EXPECT_THAT(outcome.out, HasSubstr("optimal"));
}

TEST_F(PlanCommand, HasTheJsonOfItsSchema) {
  const json found = plan_json("0,2", "3,3");
  EXPECT_EQ(found.at("planner"), "astar");
  EXPECT_EQ(found.at("status"), "found");
  EXPECT_DOUBLE_EQ(found.at("cost").get<double>(), 2 + std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(found.at("length_cells").get<double>(), 2 + std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(found.at("length_m").get<double>(), 2 + std::sqrt(2.0));
  EXPECT_EQ(found.at("path"), json({{0, 2}, {1, 2}, {2, 2}, {3, 3}}));
  EXPECT_EQ(found.at("path_m"), json({{0.5, 2.5}, {1.5, 2.5}, {2.5, 2.5}, {3.5, 3.5}}));
  EXPECT_EQ(found.at("bound"), 1);
  const json& metrics = found.at("metrics");
  EXPECT_GE(metrics.at("expanded"), 4);
  EXPECT_GE(metrics.at("generated"), metrics.at("expanded"));
  EXPECT_GE(metrics.at("max_frontier"), 1);
}

TEST_F(PlanCommand, TellsWhatCameBeforeTheSearch) {
  const json found = plan_json("0,2", "3,3");
  EXPECT_THAT(plan("0,2", "3,3", {"--format", "json"}).out, StartsWith(R"({"schema":1,)"));
  for (const char* key : {"load_us", "free_space_us", "planner_us", "search_us"}) {
    EXPECT_GT(found.at("times").at(key), 0) << key;
  }
  EXPECT_TRUE(found.at("times").at("index_us").is_null());
  EXPECT_THAT(plan("0,2", "3,3", {"--times"}).out,
              AllOf(HasSubstr(" to search, "), HasSubstr(" in all (CPU time)\n"),
                    HasSubstr("\nbefore    map "), HasSubstr(", free space "),
                    HasSubstr(", planner "), HasSubstr(" MB at most"), Not(HasSubstr("index"))));
}

TEST_F(PlanCommand, TellsTimesAndMemoryOnlyWhereTheyAreAskedFor) {
  EXPECT_THAT(plan("0,2", "3,3").out,
              AllOf(HasSubstr("\nexpanded  "), Not(HasSubstr("\ntime ")),
                    Not(HasSubstr("\nbefore ")), Not(HasSubstr("\nmemory "))));
  for (const std::string format : {"json", "csv"}) {
    const Outcome idle = plan("0,2", "3,3", {"--times", "--format", format});
    EXPECT_EQ(idle.code, 2);
    EXPECT_THAT(idle.err, HasSubstr("--times changes nothing"));
  }
}

TEST_F(PlanCommand, CountsExpansionsFromWhereItIsAsked) {
  const std::string course =
      folder_.write("course.txt", "..#...\n......\n..#.#.\n..#.#.\n..#.#.\n");
  const auto planned = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {"plan", course, "--start", "0,0", "--goal", "5,4", "--planner", "dijkstra",
                 "--connectivity", "4", "--neighbour-order", "uldr", "--ties", "sorted"});
    return wend(std::move(more));
  };
  EXPECT_THAT(planned({"--show", "expansion", "--count-from", "0"}).out,
              HasSubstr(" 0  1  # 11 15 18\n"
                        " 2  3  5  8 12 16\n"
                        " 4  6  # 13  # 19\n"
                        " 7  9  # 17  # 21\n"
                        "10 14  # 20  # 22\n"));
  EXPECT_THAT(planned({"--show", "expansion"}).out, HasSubstr(" 1  2  # 12 16 19\n"));
  const auto layer = [&](const std::string& goal, const std::string& from) {
    const Outcome outcome =
        wend({"plan", course, "--start", "0,0", "--goal", goal, "--planner", "bfs", "--show",
              "expansion", "--count-from", from, "--format", "json"});
    return json::parse(outcome.out).at("layers").at("expansion");
  };
  EXPECT_EQ(layer("0,0", "0"), json::parse("[[0,-1,-1,-1,-1,-1],[-1,-1,-1,-1,-1,-1],"
                                           "[-1,-1,-1,-1,-1,-1],[-1,-1,-1,-1,-1,-1],"
                                           "[-1,-1,-1,-1,-1,-1]]"));
  EXPECT_EQ(layer("0,0", "1")[0], json({1, nullptr, nullptr, nullptr, nullptr, nullptr}));
  const Outcome idle = planned({"--show", "g", "--count-from", "0"});
  EXPECT_EQ(idle.code, 2);
  EXPECT_THAT(idle.err, HasSubstr("--count-from changes nothing"));
}

TEST_F(PlanCommand, AnswersTheSameWhetherOrNotItIsWatched) {
  const json alone = plan_json("0,2", "3,3");
  const json watched = plan_json("0,2", "3,3", {"--show", "expansion", "--verbose"});
  for (const char* key : {"path", "cost", "metrics"}) EXPECT_EQ(watched.at(key), alone.at(key));
  double last = 0;
  for (const json& row : watched.at("layers").at("expansion")) {
    for (const json& number : row) {
      if (number.is_number()) last = std::max(last, number.get<double>());
    }
  }
  EXPECT_EQ(last, alone.at("metrics").at("expanded").get<double>());
}

TEST_F(PlanCommand, KeepsAwayFromObstaclesWhenAsked) {
  map_ = folder_.write("wall.txt", "......\n......\n......\n.####.\n");
  const json close = plan_json("0,2", "5,2");
  EXPECT_EQ(close.at("path").at(2), json({2, 2}));
  EXPECT_EQ(plan_json("0,2", "5,2", {"--clearance-distance", "0"}).at("path"), close.at("path"));
  EXPECT_EQ(
      plan_json("0,2", "5,2", {"--clearance-distance", "2", "--clearance-cost", "0"}).at("cost"),
      5);
  const json away =
      plan_json("0,2", "5,2", {"--clearance-distance", "2", "--clearance-cost", "10"});
  EXPECT_LT(away.at("path").at(2).at(1), 2);
  EXPECT_GT(away.at("cost"), away.at("length_cells"));
  EXPECT_EQ(away.at("bound"), 1);
  EXPECT_THAT(plan("0,2", "5,2", {"--clearance-distance", "-1"}).err,
              HasSubstr("--clearance-distance"));
}

TEST_F(PlanCommand, FailsWithTheReasonAndTheMetrics) {
  struct Case {
    std::string start, goal;
    std::vector<std::string> more;
    std::string status;
    std::string message;
  };
  const std::vector<Case> cases{
      {"-1,0", "4,3", {}, "start_outside", "covers the cells with x from 0 to 6 and y from 0 to 3"},
      {"1e300,0", "4,3", {}, "start_outside", "the start (1e300,0) is outside"},
      {"0,0", "7,0", {}, "goal_outside", "the goal (7,0) is outside"},
      {"1,1", "0,0", {}, "start_blocked", "the cell is an obstacle"},
      {"0,0", "2,1", {}, "goal_blocked", "connected to the start is (2,0), 1 cell away"},
      {"0,0", "6,3", {}, "goal_blocked", "the cell is unknown (--unknown free"},
      {"0,3", "3,3", {"--robot-radius", "1"}, "goal_blocked", "the robot's radius is 1 cell"},
      {"0,0",
       "6,0",
       {},
       "unreachable",
       "start's connected component has 16 cells, the goal's has 3 cells"},
      {"0,0", "4,3", {"--limit-expansions", "2"}, "expansion_limit", "after 2 expansions"},
      {"0,0", "4,3", {"--limit-time", "0"}, "time_limit", "--limit-time 0"},
      {"0,0", "4,3", {"--planner=random_walk", "--max-steps=2"}, "step_limit", "after 2 steps"},
  };
  for (const Case& failing : cases) {
    const Outcome text = plan(failing.start, failing.goal, failing.more);
    EXPECT_EQ(text.code, 1) << failing.status;
    EXPECT_THAT(text.err, AllOf(StartsWith("wend: "), HasSubstr(failing.message)));
    EXPECT_THAT(text.out, Not(HasSubstr(">(")));
    const json failed = plan_json(failing.start, failing.goal, failing.more);
    EXPECT_EQ(failed.at("status"), failing.status);
    EXPECT_THAT(failed.at("reason").get<std::string>(), HasSubstr(failing.message));
    EXPECT_EQ(failed.at("path"), json::array());
    EXPECT_EQ(failed.at("path_m"), json::array());
    EXPECT_TRUE(failed.at("cost").is_null() && failed.at("length_m").is_null());
    EXPECT_TRUE(failed.at("metrics").contains("max_frontier"));
  }
}

TEST_F(PlanCommand, PlansNothingForBadInput) {
  const std::vector<std::vector<std::string>> cases{
      {"--start", "0.5,0", "--goal", "1,0"},
      {"--start", "nan,0", "--goal", "1,0"},
      {"--start", "inf,0", "--goal", "1,0"},
      {"--start", "0", "--goal", "1,0"},
      {"--start", "0,0,0", "--goal", "1,0"},
      {"--start", "0 0", "--goal", "1,0"},
      {"--start", "a,b", "--goal", "1,0"},
      {"--start", "0,0", "--goal", "1,0", "--robot-radius", "-1"},
      {"--start", "0,0", "--goal", "1,0", "--robot-radius", "nan"},
      {"--start", "0,0", "--goal", "1,0", "--robot-radius", "inf"},
      {"--start", "0,0", "--goal", "1,0", "--limit-time", "-1"},
      {"--start", "0,0", "--goal", "1,0", "--limit-expansions", "-1"},
      {"--start", "0,0", "--goal", "1,0", "--unknown", "maybe"},
      {"--start", "0,0", "--goal", "1,0", "--planner", "astr"},
      {"--start", "0,0", "--goal", "1,0", "--planner", "astar,bfs"},
      {"--start", "0,0", "--goal", "1,0", "--weight", "-1"},
      {"--start", "0,0", "--goal", "1,0", "--weight", "x"},
      {"--start", "0,0", "--goal", "1,0", "--connectivity", "6"},
      {"--start", "0,0", "--goal", "1,0", "--planner", "bfs", "--weight", "2"},
      {"--start", "0,0", "--goal", "1,0", "-o", "plan.bmp"},
      {"--start", "0,0", "--goal", "1,0", "-o", "plan"},
      {"--start", "0,0", "--goal", "1,0", "-o", "no/such/folder/plan.png"},
  };
  for (const auto& arguments : cases) {
    const Outcome outcome = plan(arguments);
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.out, IsEmpty()) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.err, StartsWith("wend: "));
  }
}

TEST_F(PlanCommand, TakesBlanksAroundTheNumbersOfAPlace) {
  EXPECT_EQ(plan({"--start", "0, 0", "--goal", " 1 ,0 "}).code, 0);
  EXPECT_EQ(plan({"--planner", "car", "--start", "0, 0, E", "--goal", "1, 0, any"}).code, 0);
}

TEST_F(PlanCommand, SaysWhatNumberWasMeantAndInWhichRange) {
  EXPECT_THAT(
      plan("0,0", "1,0", {"--robot-radius", "0,2"}).err,
      HasSubstr("--robot-radius: '0,2' is not a number: the decimal point is a dot, did you "
                "mean 0.2?"));
  for (const std::string number : {"1e308", "1e999", "-1"}) {
    EXPECT_THAT(plan("0,0", "1,0", {"--robot-radius", number}).err,
                HasSubstr("--robot-radius: '" + number +
                          "' is not between 0 and 1e+09 metres (cells on maps in cells"));
  }
  EXPECT_THAT(plan("0,0", "1,0", {"--limit-time", "-1"}).err,
              HasSubstr("--limit-time: '-1' is not between 0 and 1e+09 s"));
  EXPECT_THAT(plan("0,0", "1,0", {"--planner", "astar", "--weight", "1e308"}).err,
              HasSubstr("--weight: '1e308' is not between 0 and 1e+06"));
}

TEST_F(PlanCommand, SaysWhichPlannersHaveAnOption) {
  EXPECT_THAT(plan("0,0", "1,0", {"--planner", "bfs", "--weight", "2"}).err,
              HasSubstr("the planner 'bfs' has no option --weight; astar"));
}

TEST_F(PlanCommand, TakesItsPlannersOptionsAsFlags) {
  EXPECT_EQ(plan_json("0,0", "4,3", {"--weight", "2"}).at("bound"), 2);
  EXPECT_EQ(plan_json("0,0", "4,3", {"--lambda", "2"}).at("bound"), 2);
  EXPECT_EQ(plan_json("0,0", "4,3", {"--planner", "astar:weight=2"}).at("bound"), 2);
  EXPECT_EQ(plan_json("0,2", "2,2", {"--planner", "greedy"}).at("bound"), json());
  EXPECT_EQ(plan_json("3,2", "4,3", {"--connectivity", "4"}).at("length_cells"), 2);
  EXPECT_GT(plan_json("3,2", "4,1").at("length_cells"), 4);
  for (const std::string flag : {"--corner-rule", "--corner_rule"}) {
    EXPECT_LT(plan_json("3,2", "4,1", {flag, "both"}).at("length_cells"), 2);
  }
}

TEST_F(PlanCommand, MarksWhatARandomWalkVisited) {
  const Outcome walk = plan("0,0", "4,3", {"--planner", "random_walk", "--seed", "4"});
  EXPECT_EQ(walk.code, 0);
  EXPECT_THAT(walk.out, AllOf(StartsWith("(0,0)>"), HasSubstr("*"), HasSubstr("* expanded"),
                              HasSubstr("no guarantee"), Not(HasSubstr("→"))));
}

TEST_F(PlanCommand, NearestMovesBlockedEnds) {
  const Outcome goal = plan("0,0", "2,1", {"--nearest"});
  EXPECT_EQ(goal.code, 0);
  EXPECT_THAT(goal.out, StartsWith("(0,0)>(1,0)>(2,0)\n"));
  EXPECT_THAT(goal.err, HasSubstr("planning to (2,0), 1 cell away"));
  const json start = plan_json("5,1", "6,0", {"--nearest"});  // (4,1) is as near, but walled off
  EXPECT_EQ(start.at("path"), json({{6, 1}, {6, 0}}));
  const json both = plan_json("1,1", "5,3", {"--nearest"});
  EXPECT_EQ(both.at("path").front(), json({1, 0}));
  EXPECT_EQ(both.at("path").back(), json({4, 3}));
  EXPECT_EQ(plan_json("0,0", "9,9", {"--nearest"}).at("status"), "goal_outside");
  const json walled_in = plan_json("0,0", "6,0", {"--nearest"});
  EXPECT_EQ(walled_in.at("status"), "found");
  EXPECT_GT(walled_in.at("remaining").at("cells"), 0);
  EXPECT_EQ(plan_json("0,0", "6,0", {"--nearest", "--nearest-limit", "0.9"}).at("status"),
            "unreachable");
}

TEST_F(PlanCommand, OfSeveralGoalsTheCheapestIsReached) {
  const std::vector<std::string> goals{"--start", "0,0",    "--goal", "4,3",    "--goal",
                                       "9,9",     "--goal", "2,0",    "--show", "cost"};
  const Outcome outcome = plan(goals);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("(0,0)>(1,0)>(2,0)\n"), HasSubstr("(2,0), one of 3 goals")));
  const Outcome none = plan({"--start", "0,0", "--goal", "6,0", "--goal", "9,9", "--goal", "1,1"});
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, AllOf(HasSubstr("none of 3 goals can be reached: there is no path to the "
                                        "goal (6,0); the goal (9,9) is outside"),
                              HasSubstr("; the goal (1,1) is blocked: the cell is an obstacle")));
  const Outcome nearest = plan({"--start", "0,0", "--goal", "2,1", "--goal", "4,3", "--nearest"});
  EXPECT_EQ(nearest.code, 0) << nearest.err;
  EXPECT_THAT(nearest.out, StartsWith("(0,0)>(1,0)>(2,0)\n"));
  EXPECT_THAT(nearest.err, HasSubstr("the goal (2,1) is blocked: the cell is an obstacle; planning "
                                     "to (2,0), 1 cell away"));
}

TEST_F(PlanCommand, EndsWithinTheToleranceOfAGoal) {
  const auto to = [&](const std::string& goal, const std::string& tolerance) {
    return plan("0,0", goal, {"--goal-tolerance", tolerance});
  };
  EXPECT_THAT(to("4,3", "0").out, HasSubstr(">(4,3)\n"));
  EXPECT_THAT(to("2,1", "1").out, StartsWith("(0,0)>(1,0)>(2,0)\n")) << "the goal is blocked";
  EXPECT_THAT(to("2,0", "1").out, StartsWith("(0,0)>(1,0)\n"));
  EXPECT_THAT(to("6,0", "1").err,
              HasSubstr("No place within its tolerance of 1 cell can be reached"));
  EXPECT_THAT(to("2,1", "0.5").err,
              HasSubstr("The robot fits nowhere within its tolerance of 0.5 cells"));
  for (const char* wrong : {"-1", "near", "nan", "1,2,3", "1,", "inf"}) {
    const Outcome outcome = to("2,1", wrong);
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr("--goal-tolerance: ")) << wrong;
  }
  EXPECT_THAT(to("2,1", "1,10").err, HasSubstr("grid planners have no headings"));
}

TEST_F(PlanCommand, FromCellToCellThereAreNoHeadings) {
  for (const auto& [start, goal] : {std::pair{"0,0,E", "4,3"}, std::pair{"0,0", "4,3,any"}}) {
    const Outcome outcome = plan(start, goal);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("has a heading"));
  }
}

TEST_F(PlanCommand, UnknownCellsMayBeFree) {
  EXPECT_EQ(plan_json("6,0", "6,3").at("status"), "goal_blocked");
  EXPECT_EQ(plan_json("6,0", "6,3", {"--unknown", "free"}).at("length_cells"), 3);
}

TEST_F(PlanCommand, StartMayBeTheGoal) {
  const json same = plan_json("4,0", "4,0");
  EXPECT_EQ(same.at("path"), json({{4, 0}}));
  EXPECT_EQ(same.at("cost"), 0);
}

TEST_F(PlanCommand, WritesFilesByTheirNames) {
  const std::string png = folder_ / "plan.png";
  const std::string svg = folder_ / "plan.SVG";
  const std::string csv = folder_ / "plan.csv";
  const std::string file = folder_ / "plan.json";
  const Outcome outcome =
      plan("0,2", "3,3", {"-o", png, "-o", svg, "--output", csv, "-o", file, "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(bytes_of(png), StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
  EXPECT_EQ(bytes_of(csv), "x,y,x_m,y_m\n0,2,0.5,2.5\n1,2,1.5,2.5\n2,2,2.5,2.5\n3,3,3.5,3.5\n");
  EXPECT_EQ(bytes_of(file), outcome.out);
}

TEST_F(PlanCommand, NoPictureWhereNoneIsWanted) {
  EXPECT_THAT(plan("0,0", "4,3", {"--picture", "never"}).out, Not(HasSubstr("###")));
}

// 1 m by 0.5 m at 0.25 m a cell, turned by nothing, its corner at (-0.5, -1).
class MetricPlan : public PlanCommand {
 protected:
  MetricPlan() {
    folder_.write("map.pgm", "P2\n4 2\n255\n254 254 254 254\n254 0 254 254\n");
    map_ = folder_.write("map.yaml",
                         "image: map.pgm\nresolution: 0.25\norigin: [-0.5, -1, 0]\nnegate: 0\n"
                         "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  }
};

TEST_F(MetricPlan, CountsInMetres) {
  const json found = plan_json("-0.4,-0.9", "0.1,-0.99");
  EXPECT_EQ(found.at("path"), json({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}}));
  EXPECT_EQ(found.at("path_m").size(), 5U);
  EXPECT_EQ(found.at("path_m").front(), json({-0.4, -0.9}));
  EXPECT_EQ(found.at("path_m").at(1), json({-0.375, -0.625}));
  EXPECT_NEAR(found.at("path_m").back().at(0).get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(found.at("path_m").back().at(1).get<double>(), -0.99, 1e-12);
  EXPECT_EQ(found.at("cost"), 4) << "of the way between the centres";
  const double metres = std::hypot(0.025, 0.275) + 0.5 + std::hypot(0.025, 0.365);
  EXPECT_NEAR(found.at("length_m").get<double>(), metres, 1e-9);
  EXPECT_THAT(plan("-0.4,-0.9", "0.1,-0.99").out,
              AllOf(HasSubstr("(0,0)>(0,1)>(1,1)>(2,1)>(2,0)\n"), HasSubstr("cells, 1.14199 m")));
  const std::string csv = folder_ / "path.csv";
  plan("-0.4,-0.9", "0.1,-0.99", {"-o", csv});
  EXPECT_THAT(bytes_of(csv), AllOf(StartsWith("x,y,x_m,y_m\n0,0,-0.4,-0.9\n0,1,-0.375,-0.625\n"),
                                   HasSubstr("\n2,0,0.0999")));
  EXPECT_THAT(wend({"check", map_, csv}).out, HasSubstr("length, m                     1.142"))
      << "the ends are read back";
}

TEST_F(MetricPlan, GoesFromCellToCellBetweenCentres) {
  const json found = plan_json("-0.375,-0.875", "0.125,-0.875");
  EXPECT_EQ(found.at("path"), json({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}}));
  EXPECT_EQ(found.at("path_m").front(), json({-0.375, -0.875}));
  EXPECT_EQ(found.at("length_cells"), 4);
  EXPECT_EQ(found.at("length_m"), 1);
  EXPECT_THAT(plan("-0.375,-0.875", "0.125,-0.875").out, HasSubstr("4 cells, 1 m"));
}

TEST_F(MetricPlan, DoesNotWriteOverTheMapItReads) {
  map_ = folder_ / "made.yaml";
  const std::string image = folder_ / "made.png";
  ASSERT_EQ(wend({"generate", "random", "--size", "8x8", "-o", map_}).code, 0);
  const std::string before = bytes_of(image);
  for (const std::string& name : {image, std::string(folder_ / "." / "made.png")}) {
    const Outcome outcome = plan("1,1", "6,6", {"-o", name});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("this file is also an input"));
    EXPECT_EQ(bytes_of(image), before);
  }
}

TEST_F(MetricPlan, CountsInCellsWhenAsked) {
  EXPECT_EQ(plan_json("0,0", "2,0", {"--cells"}).at("path").size(), 5U);
  EXPECT_EQ(plan_json("0,1", "3,1", {"--cells", "--robot-radius", "0.4"}).at("status"), "found");
  EXPECT_EQ(plan_json("0,1", "3,1", {"--cells", "--robot-radius", "0.6"}).at("status"),
            "start_blocked")
      << "it would leave the map";
  EXPECT_EQ(plan_json("0,1", "3,1", {"--cells", "--robot-radius", "0.6", "--outside", "free"})
                .at("status"),
            "unreachable");
  EXPECT_EQ(plan_json("-0.4,-0.6", "0.3,-0.6", {"--robot-radius", "0.1"}).at("status"), "found");
}

TEST_F(MetricPlan, KeepsAwayInTheUnitsTyped) {
  const json in_metres = plan_json("-0.4,-0.9", "0.1,-0.99", {"--clearance-distance", "0.5"});
  const json in_cells = plan_json("0,0", "2,0", {"--cells", "--clearance-distance", "2"});
  EXPECT_GT(in_metres.at("cost"), in_metres.at("length_cells"));
  EXPECT_EQ(in_metres.at("cost"), in_cells.at("cost"));
}

TEST_F(MetricPlan, TalksInTheUnitsTyped) {
  EXPECT_THAT(plan("5,5", "0,-0.9").err,
              AllOf(HasSubstr("the start (5,5) m, cell (22,24) is outside"),
                    HasSubstr("x from -0.5 to 0.5 m and y from -1 to -0.5 m")));
  EXPECT_THAT(plan("5,5", "0,0", {"--cells"}).err, HasSubstr("the cells with x from 0 to 3"));
  EXPECT_THAT(plan("-0.2,-0.9", "0.1,-0.9").err,
              AllOf(HasSubstr("the start (-0.2,-0.9) m, cell (1,0) is blocked"),
                    HasSubstr("0.25 m away: --nearest")));
  EXPECT_THAT(plan("0,0.5", "0,0", {"--cells"}).err, HasSubstr("without --cells, X,Y are metres"));
}

class FieldCommand : public PlanCommand {
 protected:
  Outcome field(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"field", map_});
    return wend(std::move(arguments));
  }
};

TEST_F(FieldCommand, ShowsCostsPolicyAndPaths) {
  const Outcome outcome = field({"--goal", "0,0", "--start", "2,2", "--start=4,0"});
  EXPECT_THAT(outcome.out, AllOf(Not(HasSubstr("before ")), Not(HasSubstr("planner"))));
  EXPECT_THAT(field({"--goal", "0,0", "--times"}).out,
              AllOf(HasSubstr(" in all (CPU time)\n"), HasSubstr("before    map "),
                    HasSubstr(" MB at most"), Not(HasSubstr("planner"))));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("0.00 1.00 2.00 3.00 4.00    #    -\n"), HasSubstr("G ← ← ← ← # .\n"),
                    HasSubstr("(2,2)>(1,2)>(0,2)>(0,1)>(0,0)\n"),
                    HasSubstr("from (4,0): cost 4, 4 steps\n")));
}

TEST_F(FieldCommand, HasJsonWithTheGridWhenAsked) {
  const json plain = json::parse(
      field({"--goal", "0,0", "--goal", "6,0", "--start", "6,2", "--format", "json"}).out);
  EXPECT_EQ(plain.at("goals"), json({{0, 0}, {6, 0}}));
  EXPECT_FALSE(plain.contains("grid"));
  EXPECT_EQ(plain.at("starts").at(0).at("start"), json({6, 2}));
  EXPECT_EQ(plain.at("starts").at(0).at("path"), json({{6, 2}, {6, 1}, {6, 0}}));
  EXPECT_EQ(plain.at("starts").at(0).at("cost"), 2);
  const json grid =
      json::parse(field({"--goal", "0,0", "--grid", "--format", "json"}).out).at("grid");
  EXPECT_EQ(grid.at("costs").at(0).at(4), 4);
  EXPECT_TRUE(grid.at("costs").at(0).at(6).is_null());
  EXPECT_EQ(grid.at("policy").at(0).at(4), "left");
  EXPECT_TRUE(grid.at("policy").at(0).at(0).is_null());
}

TEST_F(FieldCommand, WritesEveryCell) {
  const std::string csv = folder_ / "field.csv";
  EXPECT_EQ(field({"--goal", "0,0", "-o", csv}).code, 0);
  EXPECT_THAT(bytes_of(csv),
              AllOf(StartsWith("x,y,cost,move\n0,0,0,\n1,0,1,left\n"), HasSubstr("\n5,0,,\n")));
}

TEST_F(FieldCommand, SaysWhyThereIsNone) {
  EXPECT_THAT(field({"--goal", "9,9"}).err, HasSubstr("the goal (9,9) is outside"));
  EXPECT_THAT(field({"--goal", "1,1"}).err, HasSubstr("the goal (1,1) is blocked"));
  EXPECT_EQ(field({"--goal", "0,0", "--goal", "1,1"}).code, 0) << "the other goal is left out";
  EXPECT_EQ(field({"--goal", "0,0", "--limit-expansions", "3"}).code, 1);
  EXPECT_EQ(field({"--goal", "0,0", "--weight", "3"}).code, 2);
  EXPECT_EQ(field({"--goal", "0"}).code, 2);
  EXPECT_EQ(field({}).code, 2);
  const Outcome mixed =
      field({"--goal", "0,0", "--start", "6,0", "--start", "1,0", "--format", "json"});
  EXPECT_EQ(mixed.code, 1);
  EXPECT_THAT(mixed.err, HasSubstr("the start's connected component has 3 cells"));
  EXPECT_EQ(json::parse(mixed.out).at("starts").at(0).at("status"), "unreachable");
  EXPECT_EQ(json::parse(mixed.out).at("starts").at(1).at("status"), "found");
}

}  // namespace
}  // namespace wend::test
