// `wend compare`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/command_line/run_program.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/animation/gif_test_support.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kComparedGrid =
    "........\n"
    ".####.#.\n"
    ".....3#.\n"
    "..#...#.\n"
    "..#..###\n"
    "..#..#..\n";

class CompareCommand : public testing::Test {
 protected:
  Outcome compare(std::vector<std::string> more) const {
    more.insert(more.begin(), {"compare", map_});
    return wend(std::move(more));
  }

  /// The rows of the one query.
  json rows(std::vector<std::string> more) const {
    more.insert(more.end(), {"--format", "json"});
    return json::parse(compare(std::move(more)).out).at("queries")[0].at("planners");
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kComparedGrid);
};

std::vector<std::string> names_of(const json& rows) {
  std::vector<std::string> names;
  for (const json& row : rows) names.push_back(row.at("planner"));
  return names;
}

TEST_F(CompareCommand, RunsSixPlannersThatDifferOnTheSameQuery) {
  const Outcome outcome = compare({"--start", "0,0", "--goal", "4,5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("* best"));
  // The map has terrain: who refuses it is left out, and others stand in.
  const auto names = names_of(rows({"--start", "0,0", "--goal", "4,5"}));
  EXPECT_EQ(names.size(), 6U);
  for (const std::string& name : names) {
    EXPECT_NE(terrain_in_words(*planners().find(name)), "refused") << name;
  }
  map_ = folder_.write("flat.txt", ".....\n.##..\n.....\n");
  EXPECT_EQ(names_of(rows({"--start", "0,0", "--goal", "4,2"})),
            (std::vector<std::string>{"bfs", "dijkstra", "greedy", "astar", "jps", "any_angle"}));
}

/// One table for the paths and one for the searches, each with all its columns.
TEST_F(CompareCommand, ByDefaultHasTablesThatFitAndACaptionThatIsWhole) {
  const std::string office = folder_ / "office.yaml";
  ASSERT_EQ(wend({"generate", "office", "--size", "160x100", "--seed", "7", "-o", office}).code, 0);
  const std::string picture = folder_ / "compare.svg";
  const Outcome outcome =
      wend({"compare", office, "--start", "1,1", "--goal", "15,9", "-o", picture});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  int tables = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80U) << line;
    if (line.starts_with("planner ")) ++tables;
  }
  EXPECT_EQ(tables, 2);
}

TEST_F(CompareCommand, AgreesWithPlan) {
  for (const json& row : rows({"--start", "0,0", "--goal", "4,5", "--planner",
                               "astar:w=2,heuristic=euclidean,bfs:connectivity=4,dijkstra"})) {
    const auto planner = row.at("planner").get<std::string>();
    SCOPED_TRACE(planner);
    const json plan = json::parse(wend({"plan", map_, "--start", "0,0", "--goal", "4,5",
                                        "--planner", planner, "--format", "json"})
                                      .out);
    for (const char* key : {"status", "cost", "length_cells"}) EXPECT_EQ(row.at(key), plan.at(key));
    for (const char* key : {"expanded", "generated", "max_frontier"}) {
      EXPECT_EQ(row.at("metrics").at(key), plan.at("metrics").at(key)) << key;
    }
  }
}

TEST_F(CompareCommand, TakesSeveralGoalsAndATolerance) {
  const auto compared = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--start", "0,0", "--goal", "4,5", "--goal", "2,0", "--planner",
                               "astar,dijkstra"});
    return compare(std::move(more)).out;
  };
  const json several = json::parse(compared({"--format", "json"})).at("queries").at(0);
  EXPECT_EQ(several.at("goals"), json({{4, 5}, {2, 0}}));
  EXPECT_FALSE(several.contains("goal"));
  const json near =
      json::parse(compared({"--format", "json", "--goal-tolerance", "1"})).at("queries").at(0);
  EXPECT_EQ(near.at("goal_tolerance_cells"), 1);
  for (int planner = 0; planner < 2; ++planner) {
    EXPECT_EQ(several.at("planners").at(planner).at("cost"), 2);
    EXPECT_EQ(near.at("planners").at(planner).at("cost"), 1);
  }
  EXPECT_THAT(compared({"--format", "csv"}), HasSubstr("\n0,0,4;2,5;0,astar,found,"));
  const Outcome idle = compare({"--random", "3", "--goal-tolerance", "1"});
  EXPECT_EQ(idle.code, 2);
  EXPECT_THAT(idle.err, HasSubstr("--goal-tolerance"));
}

TEST_F(CompareCommand, SaysWhyThereIsNoPath) {
  const Outcome outcome =
      compare({"--start", "0,0", "--goal", "7,5", "--planner", "astar,bfs:corner_rule=both"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("unreachable"), HasSubstr("connected component has")));
  const json limited =
      rows({"--start", "0,0", "--goal", "4,5", "--planner", "dijkstra", "--limit-expansions", "3"});
  EXPECT_EQ(limited[0].at("status"), "expansion_limit");
  EXPECT_THAT(limited[0].at("reason").get<std::string>(), HasSubstr("--limit-expansions 3"));
}

TEST_F(CompareCommand, GivesTheSameReasonOnce) {
  const Outcome outcome =
      compare({"--start", "0,0", "--goal", "7,5", "--planner", "astar,bfs,dijkstra"});
  EXPECT_THAT(outcome.out, HasSubstr("\nastar, bfs, dijkstra: unreachable: there is no path from"));
}

TEST_F(CompareCommand, ShowsHowFarClearanceCostKeepsAPathFromWalls) {
  const std::string office = folder_ / "office.yaml";
  ASSERT_EQ(wend({"generate", "office", "--size", "100x80", "--seed", "4", "-o", office}).code, 0);
  const auto mean_clearance = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"compare", office, "--random", "40", "--planner", "astar",
                               "--robot-radius", "0.1", "--format", "json"});
    return json::parse(wend(std::move(more)).out)
        .at("statistics")[0]
        .at("clearance_cells")
        .at("mean")
        .get<double>();
  };
  EXPECT_GT(mean_clearance({"--clearance-distance", "0.6"}), mean_clearance({}));
}

TEST_F(CompareCommand, TakesRandomPairsFromASeed) {
  const std::vector<std::string> some{"--random",  "30",        "--seed",   "5",
                                      "--planner", "astar,bfs", "--format", "csv"};
  const auto without_time = [](const std::string& csv) {
    std::istringstream lines(csv);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t reason = line.rfind(',');
      std::size_t times = reason;
      for (int time = 0; time < 3; ++time) times = line.rfind(',', times - 1);
      text += line.substr(0, times) + line.substr(reason) + "\n";
    }
    return text;
  };
  const Outcome first = compare(some);
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 61);
  EXPECT_EQ(without_time(first.out), without_time(compare(some).out));
  std::vector<std::string> other = some;
  other[3] = "6";
  EXPECT_NE(without_time(first.out), without_time(compare(other).out));
  EXPECT_THAT(compare({"--random", "30"}).out,
              AllOf(HasSubstr("median"), HasSubstr("99 %"), HasSubstr("1 % least"),
                    HasSubstr("later queries, us")));
}

TEST_F(CompareCommand, ShowsPreparationFirstAndLaterQueries) {
  const json all = json::parse(
      compare({"--start", "0,0", "--goal", "4,5", "--planner", "astar,bfs", "--format", "json"})
          .out);
  EXPECT_EQ(all.at("schema"), 1);
  for (const json& row : all.at("queries")[0].at("planners")) {
    for (const char* key : {"preparation_us", "first_query_us", "later_query_us"}) {
      EXPECT_GT(row.at("times").at(key), 0) << key;
    }
  }
  const std::string table =
      compare({"--start", "0,0", "--goal", "4,5", "--planner", "astar,bfs"}).out;
  EXPECT_THAT(table, AllOf(HasSubstr("prepare"), HasSubstr("first"), HasSubstr("later"),
                           HasSubstr("Times are CPU time.")));
}

TEST_F(CompareCommand, FitsEightyColumns) {
  const std::string office = folder_ / "office.yaml";
  ASSERT_EQ(wend({"generate", "office", "--size", "100x80", "--seed", "4", "-o", office}).code, 0);
  const std::vector<std::vector<std::string>> commands{
      {"compare", office, "--random", "3", "--robot-radius", "0.1"},
      {"compare", office, "--start", "1,1", "--goal", "9,3.5"},
      {"compare", office, "--start", "1,1", "--goal", "9,3.5", "--planner",
       "astar:w=2,random_walk:max_steps=9,dijkstra"},
      {"compare", map_, "--start", "0,0,E", "--goal", "8,0"}};
  for (const std::vector<std::string>& command : commands) {
    std::istringstream lines(wend(command).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(CompareCommand, DrawsAPanelForEachPlanner) {
  const std::string svg = folder_ / "panels.svg";
  EXPECT_EQ(compare({"--start", "0,0", "--goal", "4,5", "--planner", "astar,dfs", "-o", svg, "-o",
                     folder_ / "table.csv", "-o", folder_ / "table.json"})
                .code,
            0);
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
  EXPECT_THAT(bytes_of(folder_ / "table.csv"), HasSubstr("astar"));
  EXPECT_EQ(json::parse(bytes_of(folder_ / "table.json")).at("queries").size(), 1U);
}

TEST_F(CompareCommand, FilmsTheSearchesBesideEachOther) {
  const std::string film = folder_ / "beside.gif";
  const std::vector<std::string> query{"--start", "0,0", "--goal",  "4,5",
                                       "-o",      film,  "--speed", "20"};
  const auto frames = [&](const std::string& planners) {
    std::vector<std::string> arguments = query;
    arguments.insert(arguments.end(), {"--planner", planners});
    const Outcome outcome = compare(std::move(arguments));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return decoded(bytes_of(film)).frames;
  };
  const auto astar = frames("astar");
  const auto dijkstra = frames("dijkstra");
  const auto both = frames("astar,dijkstra");
  EXPECT_LT(astar.size(), dijkstra.size());
  EXPECT_EQ(both.size(), dijkstra.size()) << "expansion by expansion until the last search ends";
  EXPECT_GT(both.front().image.width(), astar.front().image.width());
  EXPECT_THAT(compare({"--random", "3", "-o", film}).err, HasSubstr("one query only"));
  EXPECT_THAT(compare({"--start", "0,0", "--goal", "4,5", "--speed", "3"}).err,
              HasSubstr("it needs -o FILE.gif"));
}

TEST_F(CompareCommand, PlotsManyQueries) {
  const std::string plot = folder_ / "plot.svg";
  const Outcome outcome = compare({"--random", "30", "--planner", "astar,bfs", "--plot", plot});
  if (outcome.err.find("needs the program gnuplot") != std::string::npos) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(bytes_of(plot), HasSubstr("</svg>"));
}

TEST_F(CompareCommand, RefusesWhatItCannotDo) {
  const auto error_of = [&](std::vector<std::string> arguments) {
    const Outcome outcome = compare(std::move(arguments));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_THAT(error_of({}), HasSubstr("--start X,Y --goal X,Y"));
  EXPECT_THAT(error_of({"--start", "0,0"}), HasSubstr("--goal"));
  EXPECT_THAT(error_of({"--start", "0,0", "--goal", "1,0", "--random", "3"}),
              HasSubstr("--random"));
  EXPECT_THAT(error_of({"--random", "3", "-o", folder_ / "x.png"}), HasSubstr("--plot"));
  EXPECT_THAT(error_of({"--start", "0,0", "--goal", "1,0", "--plot", folder_ / "x.png"}),
              HasSubstr("--random"));
  EXPECT_THAT(error_of({"--random", "3", "--plot", folder_ / "x.gif"}),
              HasSubstr(".png, .svg or .pdf"));
  EXPECT_THAT(error_of({"--random", "3", "--planner", "astar:w=-1"}),
              AllOf(HasSubstr("astar:w=-1"), HasSubstr("not between")));
  EXPECT_THAT(error_of({"--random", "2000000"}), HasSubstr("at most 1000000"));
  const std::string full = folder_.write("full.txt", "#.#\n");
  const Outcome none = wend({"compare", full, "--random", "3"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("no two cells of this map are connected"));
}

}  // namespace
}  // namespace wend::test
