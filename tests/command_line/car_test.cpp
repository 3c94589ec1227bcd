// `wend plan --planner car`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/command_line/run_program.hpp"
#include "wend/analysis/layer.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using std::numbers::pi;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::string empty_yard(int width, int height) {
  std::string yard;
  for (int y = 0; y < height; ++y) yard += std::string(static_cast<std::size_t>(width), '.') + "\n";
  return yard;
}

std::size_t count_of(std::string_view text, std::string_view what) {
  std::size_t count = 0;
  for (auto at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

class CarCommand : public testing::Test {
 protected:
  Outcome plan(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"plan", yard_, "--planner", "car"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return wend(std::move(arguments));
  }

  Outcome plan(const std::string& start, const std::string& goal,
               std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--start", start, "--goal", goal});
    return plan(more);
  }

  json plan_json(const std::string& start, const std::string& goal,
                 std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--format", "json"});
    const Outcome outcome = plan(start, goal, std::move(more));
    EXPECT_THAT(outcome.out, StartsWith("{")) << outcome.err;
    return json::parse(outcome.out);
  }

  TemporaryFolder folder_;
  std::string yard_ = folder_.write("yard.txt", empty_yard(19, 19));
};

TEST_F(CarCommand, TellsADriverWhatToDo) {
  const Outcome outcome = plan("1,0,E", "2,2,S");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, StartsWith("Start (1,0,E)\n"
                                      "Go FWD_RIGHT -> (2,1,S)\n"
                                      "Go FWD -> (2,2,S)\n"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("steps     2: 1 turn, 0 in reverse\n"),
                                 HasSubstr("fuel      2.5708\n"), HasSubstr("optimal")));
}

TEST_F(CarCommand, CrossesAnEmptyYardInZigzag) {
  const Outcome outcome = plan("0,0,E", "18,18,E");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("steps     18: 18 turns"),
                                 HasSubstr("fuel      28.2743\n"), HasSubstr(" of 1600 states (")));
  const json found = plan_json("0,0,E", "18,18,E");
  EXPECT_NEAR(found.at("cost").get<double>(), 9 * pi, 1e-9);
  EXPECT_EQ(found.at("moves").size(), 18U);
  EXPECT_EQ(found.at("path").size(), 19U);
  EXPECT_EQ(found.at("states"), 1600);
}

TEST_F(CarCommand, HasTheJsonOfItsSchema) {
  const json found = plan_json("1,0,E", "2,2,S");
  EXPECT_EQ(found.at("planner"), "car");
  EXPECT_EQ(found.at("status"), "found");
  EXPECT_EQ(found.at("path"), json({{1, 0}, {2, 1}, {2, 2}}));
  EXPECT_EQ(found.at("headings"), json({"E", "S", "S"}));
  EXPECT_EQ(found.at("moves"), json({"FWD_RIGHT", "FWD"}));
  EXPECT_EQ(found.at("start_shift").at("cells"), 0);
  EXPECT_EQ(found.at("bound"), 1);
  EXPECT_GT(found.at("times").at("search_us"), 0);
}

TEST_F(CarCommand, TakesHeadingsAsLettersNumbersAndAngles) {
  // y is down: counted from +x towards +y, a quarter turn faces south.
  for (const char* east : {"E", "e", "2", "0deg", "-0.0rad", "360deg", "30deg", "-44.9deg"}) {
    const json found = plan_json("1,0," + std::string(east), "2,1,S");
    EXPECT_EQ(found.at("moves"), json({"FWD_RIGHT"})) << east;
  }
  for (const char* south : {"S", "s", "3", "90deg", "1.5707963267948966rad", "1.2rad", "-300deg"}) {
    const json found = plan_json("1,0,E", "2,1," + std::string(south));
    EXPECT_EQ(found.at("moves"), json({"FWD_RIGHT"})) << south;
  }
  EXPECT_EQ(plan_json("1,3,N", "1,2,0").at("moves"), json({"FWD"}));
  EXPECT_EQ(plan_json("1,3,W", "2,3,1").at("moves"), json({"REV"}));
}

TEST_F(CarCommand, AGoalMayHaveAnyHeading) {
  for (const char* goal : {"2,1", "2,1,any"}) {
    const json found = plan_json("1,0,E", goal);
    EXPECT_EQ(found.at("headings"), json({"E", "S"}));
    EXPECT_EQ(found.at("goal_shift").at("degrees"), 0);
  }
}

TEST_F(CarCommand, OfSeveralGoalsTheCheapestIsFound) {
  const Outcome outcome = plan({"--start", "5,5,E", "--goal", "9,9,W", "--goal", "99,9,any",
                                "--goal", "4,5,E", "--goal", "5,5,W"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("Start (5,5,E)\nGo REV -> (4,5,E)\n"),
                                 HasSubstr("goal      (4,5,E), one of 4 goals\n")));
}

TEST_F(CarCommand, StartMayBeTheGoal) {
  const Outcome outcome = plan("4,4,N", "4,4,N");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("Start (4,4,N)\n"), Not(HasSubstr("Go ")),
                                 HasSubstr("steps     0: 0 turns, 0 in reverse")));
}

TEST_F(CarCommand, RoughRoadCostsWhatItsOptionsSay) {
  yard_ = folder_.write("rough.txt", "~~\n~~\n");
  EXPECT_NEAR(plan_json("0,0,E", "1,1,S").at("cost").get<double>(), pi, 1e-9);
  EXPECT_EQ(plan_json("0,1,E", "2,1,E").at("cost"), 2);
  EXPECT_EQ(plan_json("0,1,E", "2,1,E", {"--straight-terrain", "max"}).at("cost"), 4);
  EXPECT_EQ(plan_json("2,1,E", "0,1,E", {"--reverse-factor", "3"}).at("cost"), 6);
}

TEST_F(CarCommand, WithAUnitItStandsOnEveryNthCorner) {
  const Outcome outcome = plan("4,0,40deg", "9,8,any", {"--unit", "4"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("Start (4,0,E)\nGo FWD_RIGHT -> (8,4,S)\nGo FWD -> (8,8,S)\n"),
                    HasSubstr("start     (4,0,E), 40 degrees from what was asked\n"),
                    HasSubstr("goal      (8,8,S), 1 cell from what was asked\n"),
                    HasSubstr("fuel      2.5708\n"), HasSubstr("length    10.2832 cells\n"),
                    HasSubstr(" of 100 states")));
  const json shifted = plan_json("4,0,40deg", "9,8,any", {"--unit", "4"});
  EXPECT_NEAR(shifted.at("start_shift").at("degrees").get<double>(), 40, 1e-9);
  EXPECT_EQ(shifted.at("goal_shift").at("cells"), 1);
}

TEST_F(CarCommand, TurnsNoTighterThanItsTurningRadius) {
  const Outcome outcome = plan("4,0,E", "8,8,S", {"--turning-radius", "3.2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("Start (4,0,E)\nGo FWD_RIGHT -> (8,4,S)\n"),
                                 HasSubstr("turns in  4 cells\n")))
      << "rounded up";
  const json found = plan_json("4,0,E", "8,8,S", {"--turning-radius", "3.2"});
  EXPECT_EQ(found.at("turning_radius_cells"), 4);
  EXPECT_EQ(wend({"plan", yard_, "--planner", "car:turning_radius=3.2", "--start", "4,0,E",
                  "--goal", "8,8,S"})
                .out.substr(0, 40),
            outcome.out.substr(0, 40));
  EXPECT_THAT(plan("4,0,E", "8,8,S", {"--turning-radius", "3", "--unit", "3"}).err,
              HasSubstr("unit and turning_radius set the same value"));
}

TEST_F(CarCommand, CountsItsTurningRadiusInMetres) {
  yard_ = folder_.write("yard.yaml",
                        "image: yard.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                        "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
  std::string pixels = "P2 40 40 255\n";
  for (int i = 0; i < 1600; ++i) pixels += "254\n";
  folder_.write("yard.pgm", pixels);
  const Outcome outcome = plan("0.2,0.2,0deg", "1.2,0.2,0deg", {"--turning-radius", "0.18"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("turns in  0.2 m, 4 cells\n"));
  EXPECT_THAT(plan("4,4,E", "24,4,E", {"--turning-radius", "4", "--cells"}).out,
              HasSubstr("turns in  4 cells\n"));
}

TEST_F(CarCommand, NamesTheFlagWhereMostStepsGoBackwards) {
  const Outcome backwards = plan("9,9,E", "5,9,E");
  EXPECT_THAT(backwards.out,
              HasSubstr("steps     4: 0 turns, 4 in reverse (--reverse-factor makes these cost"));
  EXPECT_EQ(plan_json("9,9,E", "5,9,E").at("steps_in_reverse"), 4);
  EXPECT_THAT(plan("5,9,E", "9,9,E").out, Not(HasSubstr("--reverse-factor")));
  EXPECT_EQ(plan_json("5,9,E", "9,9,E").at("steps_in_reverse"), 0);
}

// The lower left corner is boxed in.
constexpr const char* kBadYard =
    "....#.\n"
    "...##.\n"
    "......\n"
    "#.....\n"
    ".#....\n";

class BadCarInput : public CarCommand {
 protected:
  BadCarInput() { yard_ = folder_.write("bad.txt", kBadYard); }
};

TEST_F(BadCarInput, FailsWithWhereAndWhy) {
  struct Case {
    std::string start, goal;
    std::vector<std::string> more;
    std::string status;
    std::string message;
  };
  const std::vector<Case> cases{
      {"-1,0,E",
       "3,3",
       {},
       "start_outside",
       "the start (-1,0,E) is outside the map, which covers the grid vertices with x from 0 to 6 "
       "and y from 0 to 5"},
      {"0,0,E", "7,5,any", {}, "goal_outside", "the goal (7,5,any) is outside the map"},
      {"0,0,E", "1e300,5", {}, "goal_outside", "the goal (1e300,5) is outside the map"},
      {"1,3,E",
       "3,3",
       {},
       "start_blocked",
       "the start (1,3,E) is blocked: cell (0,3) next to it is an obstacle"},
      {"0,0,E", "4,0,any", {}, "goal_blocked", "(4,0,any) is blocked: cell (4,0)"},
      {"2,2,E",
       "0,0",
       {"--robot-radius", "1.5"},
       "start_blocked",
       "the start (2,2,E) is blocked: the nearest obstacle is 1"},
      {"0,5,E", "3,3", {}, "unreachable", "no motion primitive leaves the start (0,5,E)"},
      {"3,3,E", "0,5", {}, "unreachable", "no motion primitive reaches the goal (0,5,any)"},
      {"3,3,E", "6,0,N", {"--limit-expansions", "2"}, "expansion_limit", "after 2 expansions"},
      {"3,3,E", "6,0,N", {"--limit-time", "0"}, "time_limit", "--limit-time 0"},
      {"3,3,E",
       "6,0,N",
       {"--unit", "6"},
       "unsupported_map",
       "too small for a lattice_resolution of 6"},
  };
  for (const Case& failing : cases) {
    const std::string file = folder_ / "failed.json";
    std::vector<std::string> more = failing.more;
    more.insert(more.end(), {"-o", file});
    const Outcome outcome = plan(failing.start, failing.goal, more);
    EXPECT_EQ(outcome.code, 1) << failing.message;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("wend: "), HasSubstr(failing.message)));
    EXPECT_THAT(outcome.out, Not(HasSubstr("Start")));
    const json failed = json::parse(bytes_of(file));
    EXPECT_EQ(failed.at("status"), failing.status);
    EXPECT_EQ("wend: " + failed.at("reason").get<std::string>() + "\n", outcome.err);
    for (const char* list : {"path", "headings", "moves"}) {
      EXPECT_EQ(failed.at(list), json::array()) << failing.status;
    }
    EXPECT_TRUE(failed.at("cost").is_null() && failed.at("start_shift").is_null());
  }
}

TEST_F(BadCarInput, PlansNothingForWhatItDoesNotUnderstand) {
  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Case> cases{
      {{"--start", "0,0", "--goal", "3,3"},
       "--start: '0,0' has no heading, and planners of poses need one"},
      {{"--start", "0,0,Q", "--goal", "3,3"},
       "the heading 'Q' is not N, W, E or S (or 0, 1, 2, 3)"},
      {{"--start", "0,0,4", "--goal", "3,3"}, "the heading '4' is not N"},
      {{"--start", "0,0,45", "--goal", "3,3"}, "an angle such as 45deg or 0.8rad"},
      {{"--start", "0,0,infdeg", "--goal", "3,3"}, "the heading 'infdeg'"},
      {{"--start", "0,0,", "--goal", "3,3"}, "the heading ''"},
      {{"--start", "0,0,any", "--goal", "3,3"}, "the heading 'any'"},
      {{"--start", "0,0,E,E", "--goal", "3,3"}, "the heading 'E,E'"},
      {{"--start", "0,0,E", "--goal", "3,3,North"}, "--goal: '3,3,North': the heading 'North'"},
      {{"--start", "0.5,0,E", "--goal", "3,3"}, "'0.5,0' is not a corner"},
      {{"--start", "x,0,E", "--goal", "3,3"}, "--start: 'x,0' is not X,Y"},
      {{"--start", "0,0,E", "--goal", "nan,3"}, "--goal: 'nan,3' is not X,Y"},
      {{"--start", "0,0,E"}, "--goal is required"},
      {{"--start", "0,0,E", "--goal", "3,3", "--reverse-factor", "-1"}, "--reverse-factor: '-1'"},
      {{"--start", "0,0,E", "--goal", "3,3", "--unit", "0"}, "'unit': '0'"},
      {{"--start", "0,0,E", "--goal", "3,3", "--weight", "-1"}, "--weight: '-1'"},
      {{"--start", "0,0,E", "--goal", "3,3", "--heuristic", "octile"}, "'heuristic': 'octile'"},
      {{"--start", "0,0,E", "--goal", "3,3", "--connectivity", "4"}, "no option --connectivity"},
      {{"--start", "0,0,E", "--goal", "3,3", "--show", "g,policy"}, "--show"},
  };
  for (const auto& [arguments, message] : cases) {
    const Outcome outcome = plan(arguments);
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_THAT(outcome.out, IsEmpty()) << message;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("wend: "), HasSubstr(message)));
  }
}

TEST_F(BadCarInput, OnlyThePlannersOfACarTakeHeadings) {
  const std::vector<std::vector<std::string>> commands{
      {"plan", yard_, "--start", "0,0,E", "--goal", "3,3"},
      {"explain", yard_, "--start", "0,0,E", "--goal", "3,3"},
      {"field", yard_, "--goal", "3,3,N"},
  };
  for (const auto& command : commands) {
    const Outcome outcome = wend(command);
    EXPECT_EQ(outcome.code, 2) << command.front();
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("has a heading"),
                                   HasSubstr("--planner hybrid_astar, lattice or car")));
  }
}

TEST_F(BadCarInput, ScenariosAreNotForCars) {
  const std::string scenario = folder_.write("yard.scen", "version 1\n0 bad.txt 6 5 0 0 1 0 1\n");
  const Outcome outcome = wend({"bench", scenario, "--map", yard_, "--planner", "astar,car"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("car: scenarios support grid planners only"));
}

// 4 x 3 m at 0.5 m a cell: 8 x 6 cells, its corner at (1, 2), turned by 0.1.
class CarOnARosMap : public CarCommand {
 protected:
  CarOnARosMap() { make(0); }

  void make(double yaw) {
    std::string pgm = "P2\n8 6\n255\n";
    for (int i = 0; i < 48; ++i) pgm += "254 ";
    folder_.write("map.pgm", pgm);
    yard_ = folder_.write("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [1, 2, " +
                                          std::to_string(yaw) +
                                          "]\nnegate: 0\noccupied_thresh: 0.65\n"
                                          "free_thresh: 0.196\n");
  }
};

TEST_F(CarOnARosMap, CountsInMetresAndNorthIsUp) {
  const json found = plan_json("1.5,2.5,E", "2,3,N");
  EXPECT_EQ(found.at("path"), json({{1, 1}, {2, 2}}));
  EXPECT_EQ(found.at("headings"), json({"E", "N"}));
  EXPECT_EQ(found.at("moves"), json({"FWD_LEFT"}));
  EXPECT_EQ(found.at("path_m"), json({{1.5, 2.5}, {2, 3}}));
  EXPECT_NEAR(found.at("length_m").get<double>(), pi / 4, 1e-9);
  EXPECT_EQ(plan_json("1,1,E", "2,2,90deg", {"--cells"}).at("path"), found.at("path"));
}

TEST_F(CarOnARosMap, SnapsToTheNearestCornerAndSaysByHowMuch) {
  const Outcome outcome = plan("1.6,2.5,10deg", "2,3,1.4rad");
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr("start     (1.5,2.5,E) m, 0.1 m and 10 degrees from what was asked\n"),
            HasSubstr("goal      (2,3,N) m, 9.79 degrees from what was asked\n")));
  const json shifted = plan_json("1.6,2.5,10deg", "2,3,N");
  EXPECT_NEAR(shifted.at("start_shift").at("m").get<double>(), 0.1, 1e-9);
  EXPECT_NEAR(shifted.at("start_shift").at("degrees").get<double>(), 10, 1e-9);
}

TEST_F(CarOnARosMap, AnglesAreThoseOfTheMapsFrame) {
  make(1);  // radians: the grid's +x
  const json angle = plan_json("1,2,1rad", "1,2,any");
  EXPECT_EQ(angle.at("headings"), json({"E"}));
  EXPECT_NEAR(angle.at("start_shift").at("degrees").get<double>(), 0, 1e-9);
  EXPECT_EQ(plan_json("1,2,0deg", "1,2,any").at("headings"), json({"S"}));
  EXPECT_EQ(plan_json("1,2,N", "1,2,any").at("headings"), json({"N"})) << "of the grid as drawn";
}

TEST_F(CarOnARosMap, TalksInMetres) {
  EXPECT_THAT(plan("0,0,E", "2,3").err,
              HasSubstr("the start (0,0,E) m is outside the map, which covers x from 1 to 5 m"));
  EXPECT_THAT(plan("1.5,2.5,E", "2,3", {"--robot-radius", "0.3"}).out,
              HasSubstr("Start (1.5,2.5,E) m"));
  folder_.write("map.pgm", "P2\n2 2\n255\n254 0 254 254\n");
  EXPECT_THAT(plan("1,2,E", "1.5,2.5,any").err,
              StartsWith("wend: the goal (1.5,2.5,any) m is blocked"));
  EXPECT_THAT(plan("0,0,E", "1,1,any", {"--cells"}).err,
              StartsWith("wend: the goal (1,1,any) is blocked"));
}

TEST_F(CarCommand, WritesFilesByTheirNames) {
  const std::vector<std::string> names{"drive.png", "drive.svg",  "drive.pdf",
                                       "drive.csv", "drive.json", "drive.gif"};
  std::vector<std::string> more{"--format", "json"};
  for (const std::string& name : names) more.insert(more.end(), {"-o", folder_ / name});
  const Outcome outcome = plan("1,0,E", "2,2,S", more);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(bytes_of(folder_ / "drive.png"), StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_THAT(bytes_of(folder_ / "drive.svg"), HasSubstr("<svg"));
  EXPECT_THAT(bytes_of(folder_ / "drive.pdf"), StartsWith("%PDF"));
  EXPECT_THAT(bytes_of(folder_ / "drive.gif"), StartsWith("GIF89a"));
  EXPECT_THAT(bytes_of(folder_ / "drive.csv"), StartsWith("x,y,heading,x_m,y_m,yaw,gear\n1,0,E,"));
  EXPECT_EQ(bytes_of(folder_ / "drive.json"), outcome.out);
}

TEST_F(CarCommand, TellsEveryEventWithItsHeading) {
  const Outcome outcome = plan("1,0,E", "2,2,S", {"--verbose", "--format", "json"});
  EXPECT_THAT(outcome.err, StartsWith("  generate (1,0,E) f="));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("\nexpand (1,0,E) f="),
                                 HasSubstr("\n  generate (2,1,S) from (1,0,E) f=")));
  const auto expanded = json::parse(outcome.out).at("metrics").at("expanded").get<std::size_t>();
  EXPECT_EQ(count_of(outcome.err, "\nexpand ("), expanded);
}

TEST_F(CarCommand, WaitsForAKeyAfterEachExpansion) {
  const Outcome outcome = shell("printf nq | \"$WEND\" plan '" + yard_ +
                                "' --planner car --start 1,0,E --goal 9,9 --step --show g");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("cancelled after 2 expansions"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("expansion 1: (1,0,E) f="), HasSubstr("expansion 2: ("),
                                 HasSubstr("g, cost from the start\n")));
}

TEST_F(CarCommand, ShowsEveryLayerOfSearchAndMap) {
  yard_ = folder_.write("small.txt", empty_yard(4, 3));
  std::string names;
  std::vector<LayerKind> kinds;
  for (const auto& choice : choice_names(LayerKind{})) {
    if (source_of(choice.value) == LayerSource::cost_to_go) continue;
    kinds.push_back(choice.value);
    names += (names.empty() ? "" : ",") + std::string(choice.name);
  }
  const Outcome outcome = plan("0,0,E", "4,3", {"--show", names});
  for (const LayerKind kind : kinds) EXPECT_THAT(outcome.out, HasSubstr(title_of(kind)));
  const json layers = plan_json("0,0,E", "4,3", {"--show", names}).at("layers");
  EXPECT_EQ(layers.size(), kinds.size());
  EXPECT_EQ(layers.at("expansion").at(0).at(0), 1);
}

TEST_F(CarCommand, WritesATraceOfItsStates) {
  const std::string file = folder_ / "drive.trace.json";
  const Outcome outcome = plan("1,0,E", "2,2,S", {"--trace", file, "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json trace = json::parse(bytes_of(file));
  std::size_t expanding = 0;
  for (const json& event : trace.at("events")) {
    if (event.at("type") != "expanding") continue;
    EXPECT_TRUE(event.contains("heading"));
    ++expanding;
  }
  EXPECT_EQ(expanding, json::parse(outcome.out).at("metrics").at("expanded").get<std::size_t>());
}

}  // namespace
}  // namespace wend::test
