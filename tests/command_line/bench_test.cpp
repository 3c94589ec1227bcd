// `wend bench`: what it measures, counts as wrong, and refuses.

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/command_line/bench_folder.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class BenchCommand : public testing::Test, protected BenchFolder {};

TEST_F(BenchCommand, HasARowForEachFileAndPlanner) {
  const std::string file = scenario(kRight);
  const std::string other = scenario(kRight, "other.scen");
  const json found = rows({file, other, "--planner", "astar,astar:weight=0,bfs", "--check"});
  ASSERT_EQ(found.size(), 6U);
  const json& row = found.at(0);
  EXPECT_EQ(row.at("scen"), file);
  EXPECT_EQ(row.at("planner"), "astar");
  EXPECT_EQ(found.at(1).at("planner"), "astar:weight=0");
  EXPECT_EQ(row.at("queries"), 2);
  EXPECT_EQ(row.at("solved"), 2);
  EXPECT_EQ(row.at("wrong"), 0);
  EXPECT_EQ(row.at("threads"), 1);
  EXPECT_EQ(row.at("passes"), 1);
  EXPECT_EQ(row.at("spread"), 0);
  EXPECT_EQ(row.at("build_s"), 0);
  EXPECT_EQ(row.at("index_bytes"), 0);
  for (const char* key :
       {"prepare_us", "first_us", "mean_us", "median_us", "p99_us", "expanded_per_query",
        "expansions_per_second", "fastest_pass_us", "slowest_pass_us"}) {
    EXPECT_GT(row.at(key).get<double>(), 0) << key;
  }
  EXPECT_EQ(wend({"bench", file}).code, 0);
  EXPECT_THAT(wend({"bench", file}).out, StartsWith("CPU time of the thread"));
}

TEST_F(BenchCommand, WritesCsv) {
  const std::string file = scenario(kRight);
  const Outcome outcome = wend({"bench", file, "--format", "csv"});
  EXPECT_THAT(outcome.out, StartsWith("scen,planner,queries,solved,timed_out,wrong,"));
  EXPECT_THAT(outcome.out, HasSubstr("\n" + file + ",astar,2,2,0,0,"));
  EXPECT_THAT(outcome.out, HasSubstr(",fresh,version,commit\n"));
}

TEST_F(BenchCommand, TakesTheScenariosOfFolders) {
  scenario(kRight, "b.scen");
  scenario(kRight, "a.scen");
  const json found = rows({folder_ / ""});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found.at(0).at("scen").get<std::string>(), EndsWith("/a.scen"));
  EXPECT_THAT(found.at(1).at("scen").get<std::string>(), EndsWith("/b.scen"));
  const TemporaryFolder empty;
  EXPECT_THAT(wend({"bench", empty / ""}).err, HasSubstr("contains no .scen file"));
}

TEST_F(BenchCommand, BuildsAnIndexThatIsNotGivenBeforeItCounts) {
  const std::string file = scenario(kRight);
  for (const char* planner : {"hub_labels", "euclidean_labels"}) {
    const json row = rows({file, "--planner", planner}).at(0);
    EXPECT_EQ(row.at("wrong"), 0) << planner;
    EXPECT_EQ(row.at("solved"), 2) << planner;
    EXPECT_GT(row.at("build_s").get<double>(), 0) << planner;
    EXPECT_GT(row.at("index_bytes").get<double>(), 0) << planner;
  }
}

TEST_F(BenchCommand, TakesTheIndexThatIsGiven) {
  const std::string file = scenario(kRight);
  const std::string index = folder_ / "ok.idx";
  ASSERT_EQ(wend({"index", "build", folder_ / "ok.map", "-o", index}).code, 0);
  const json row = rows({file, "--planner", "astar,hub_labels", "--index", index}).at(1);
  EXPECT_EQ(row.at("planner"), "hub_labels");
  EXPECT_EQ(row.at("wrong"), 0);
  EXPECT_EQ(row.at("build_s"), 0);
  EXPECT_EQ(row.at("index_bytes"), std::filesystem::file_size(index));
}

TEST_F(BenchCommand, RefusesAnIndexThatIsOfNoUse) {
  const std::string file = scenario(kRight);
  const std::string index = folder_ / "ok.idx";
  ASSERT_EQ(wend({"index", "build", folder_ / "ok.map", "-o", index}).code, 0);
  const auto refused = [&](const std::string& planner, const std::string& given) {
    const Outcome outcome = wend({"bench", file, "--planner", planner, "--index", given});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_THAT(refused("astar", index), HasSubstr("hub_labels, which is not in --planner"));
  EXPECT_THAT(refused("hub_labels", folder_ / "none.idx"), HasSubstr("none.idx"));
  EXPECT_THAT(refused("hub_labels", folder_ / "ok.map"), HasSubstr("ok.map"));
  const std::string other =
      folder_.write("other.map", "type octile\nheight 1\nwidth 3\nmap\n...\n");
  ASSERT_EQ(wend({"index", "build", other, "-o", index}).code, 0);
  EXPECT_THAT(refused("hub_labels", index), HasSubstr("the index is for another map"));
}

TEST_F(BenchCommand, RepeatsPassesAndShowsTheirSpread) {
  const std::string file = scenario(kRight);
  const json row = rows({file, "--repetitions", "4"}).at(0);
  EXPECT_EQ(row.at("passes"), 4);
  EXPECT_EQ(row.at("queries"), 2);
  const auto number = [&row](const char* key) { return row.at(key).get<double>(); };
  EXPECT_LE(number("fastest_pass_us"), number("slowest_pass_us"));
  EXPECT_LE(number("mean_us"), number("fastest_pass_us") * (1 + 1e-9));
  EXPECT_NEAR(number("spread"), number("slowest_pass_us") / number("fastest_pass_us") - 1, 1e-9);
  EXPECT_THAT(wend({"bench", file, "--repetitions", "2"}).out, HasSubstr("spread"));
}

TEST_F(BenchCommand, ThreadsShareTheQueries) {
  std::string queries;
  for (int i = 0; i < 50; ++i) queries += kRight;
  const std::string file = scenario(queries);
  const json one = rows({file}).at(0);
  const json two = rows({file, "--threads", "3", "--repetitions", "2", "--planner", "astar"}).at(0);
  EXPECT_EQ(two.at("threads"), 3);
  for (const char* key : {"queries", "solved", "wrong", "expanded_per_query"}) {
    EXPECT_EQ(one.at(key), two.at(key)) << key;
  }
}

TEST_F(BenchCommand, SamplesEvenly) {
  std::string queries;
  for (int x = 0; x < 5; ++x) queries += "0 ok.map 5 4 0 0 " + std::to_string(x) + " 0 9\n";
  const Outcome outcome = wend({"bench", scenario(queries), "--sample", "2"});
  EXPECT_THAT(outcome.err, HasSubstr(":2: astar: "));  // the first line is the version
  EXPECT_THAT(outcome.err, HasSubstr(":4: astar: "));
  EXPECT_EQ(rows({scenario(queries), "--sample", "2"}).at(0).at("queries"), 2);
}

TEST_F(BenchCommand, CountsWhatIsWrong) {
  struct Case {
    std::string query;
    int solved, wrong;
  };
  const std::vector<Case> cases{
      {"0 ok.map 5 4 0 0 4 3 7", 1, 1},        // another length
      {"0 ok.map 5 4 0 0 4 3 6.41427", 1, 0},  // within 1e-5 of it
      {"0 ok.map 5 4 0 0 4 3 6.41", 1, 0},     // two decimals: half a unit
      {"0 ok.map 5 4 0 0 4 3 6.414", 1, 1},    // wrong in the third decimal
      {"0 ok.map 5 4 0 0 4 3 0", 1, 1},        // the file says that there is no path
      {"0 ok.map 5 4 1 1 4 0 4", 0, 1},        // the start is blocked
      {"0 ok.map 5 4 1 1 4 0 0", 0, 0},        // and the file says so
      {"0 ok.map 5 4 2 2 2 2 0", 1, 0},        // nowhere to go
  };
  for (const Case& one : cases) {
    const std::string file = scenario(one.query + "\n");
    const json row = rows({file, "--repetitions", "2"}).at(0);
    EXPECT_EQ(row.at("solved"), one.solved) << one.query;
    EXPECT_EQ(row.at("wrong"), one.wrong) << one.query;
    const Outcome outcome = wend({"bench", file});
    EXPECT_EQ(outcome.code, one.wrong) << one.query;
    EXPECT_EQ(outcome.err.empty(), one.wrong == 0) << outcome.err;
  }
}

TEST_F(BenchCommand, ComplainsOfAFewAndCountsThemAll) {
  std::string queries;
  for (int i = 0; i < 9; ++i) queries += "0 ok.map 5 4 0 0 4 3 7\n";
  const Outcome outcome = wend({"bench", scenario(queries)});
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 6) << outcome.err;
  EXPECT_THAT(outcome.err, EndsWith("... and more\n"));
  EXPECT_EQ(rows({scenario(queries)}).at(0).at("wrong"), 9);
}

TEST_F(BenchCommand, RunsBoostBesideOurs) {
  const std::string file =
      scenario(std::string(kRight) + "0 ok.map 5 4 1 1 4 0 0\n0 ok.map 5 4 2 2 2 2 0\n");
  if (wend({"bench", file, "--planner", "boost-astar"}).code == 2) {
    GTEST_SKIP() << "the build found no Boost.Graph";
  }
  const json found = rows({file, "--planner", "boost-astar,astar", "--threads", "2"});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.at(0).at("planner"), "boost-astar");
  for (const json& row : found) {
    EXPECT_EQ(row.at("queries"), 4);
    EXPECT_EQ(row.at("solved"), 3);
    EXPECT_EQ(row.at("wrong"), 0);
  }
  EXPECT_THAT(wend({"bench", file, "--planner", "boost-astar:weight=2"}).err,
              HasSubstr("unknown option 'weight': this planner has no options"));
}

TEST_F(BenchCommand, Plots) {
  const std::string file = scenario(kRight);
  const std::string plot = folder_ / "plot.svg";
  EXPECT_THAT(wend({"bench", file, "--plot", folder_ / "plot.txt"}).err,
              HasSubstr("the name must end in .png, .svg or .pdf"));
  const Outcome outcome = wend({"bench", file, "--planner", "astar,bfs", "--plot", plot});
  if (outcome.code == 2 && outcome.err.find("gnuplot-nox") != std::string::npos) {
    GTEST_SKIP() << "gnuplot is missing";
  }
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(bytes_of(plot), HasSubstr("queries solved"));
}

TEST_F(BenchCommand, FindsTheMapOrSaysThatItCannot) {
  EXPECT_EQ(wend({"bench", scenario(kRight)}).code, 0);
  EXPECT_EQ(wend({"bench", scenario(kRight, "any.scen")}).code, 0);
  const std::string lost = scenario("0 maps/lost.map 5 4 0 0 4 0 4\n", "lost.scen");
  const Outcome outcome = wend({"bench", lost});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("its map 'lost.map' is not in the same folder"));
  EXPECT_EQ(wend({"bench", lost, "--map", folder_ / "ok.map"}).code, 0);
}

TEST_F(BenchCommand, RefusesBadInput) {
  const std::string file = scenario(kRight);
  EXPECT_EQ(wend({"bench"}).code, 2);
  EXPECT_EQ(wend({"bench", "no/such.scen"}).code, 2);
  EXPECT_EQ(wend({"bench", file, "--planner", "astr"}).code, 2);
  EXPECT_EQ(wend({"bench", file, "--planner", "astar:weight=x"}).code, 2);
  EXPECT_EQ(wend({"bench", scenario("0 ok.map 5 4 0 0 5 0 4\n")}).code, 2);
  EXPECT_EQ(wend({"bench", scenario("0 ok.map 50 40 0 0 4 0 4\n")}).code, 2);
  EXPECT_THAT(wend({"bench", scenario(kRight), "--threads", "0"}).err,
              HasSubstr("--threads 0: must be from 1 to 1024"));
  EXPECT_EQ(wend({"bench", scenario(kRight), "--repetitions", "0"}).code, 2);
  EXPECT_EQ(rows({scenario(kRight), "--passes", "2"}).at(0).at("passes"), 2);
  EXPECT_THAT(wend({"bench", scenario(kRight), "--sample", "0"}).err,
              HasSubstr("--sample 0: must be at least 1"));
  const Outcome moves = wend({"bench", scenario(kRight), "--planner", "astar:connectivity=4"});
  EXPECT_EQ(moves.code, 2);
  EXPECT_THAT(moves.err, HasSubstr("set --connectivity"));
  const Outcome jps = wend({"bench", scenario(kRight), "--planner", "jps", "--connectivity", "4"});
  EXPECT_EQ(jps.code, 2);
  EXPECT_THAT(jps.err, HasSubstr("supports only 8 neighbours without corner cutting"));
  EXPECT_THAT(wend({"bench", scenario(kRight), "--per-query", folder_ / "none/q.csv"}).err,
              HasSubstr("--per-query"));
  const std::string kept = scenario(kRight);
  EXPECT_EQ(wend({"bench", kept, "--per-query", kept}).code, 2);
  const std::string queries = "start,goal\n\"1,1\",\"2,2\"\n";
  const std::string other = folder_.write("queries.csv", queries);
  const auto refused = wend({"bench", scenario(kRight), "--per-query", other});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("is not what the option writes"));
  EXPECT_EQ(bytes_of(other), queries);
  EXPECT_THAT(bytes_of(kept), HasSubstr("ok.map"));
}

TEST_F(BenchCommand, SaysWhatWasRun) {
  const json result = results({scenario(kRight)});
  EXPECT_TRUE(result.at("schema").is_number_integer());
  EXPECT_EQ(result.at("times"), "CPU time");
  EXPECT_THAT(result.at("version").get<std::string>(), testing::MatchesRegex("[0-9.]+"));
  EXPECT_FALSE(result.at("commit").get<std::string>().empty());
  EXPECT_EQ(result.at("robot"), "a point, 8 neighbours, no corner cutting");
}

TEST_F(BenchCommand, AsksANewPlannerEveryQuery) {
  std::string queries;
  for (int i = 0; i < 30; ++i) queries += kRight;
  const std::string file = scenario(queries);
  const json kept = rows({file, "--planner", "jps"}).at(0);
  EXPECT_EQ(kept.at("first_queries"), 10);
  const json fresh = results({file, "--planner", "jps", "--fresh"});
  EXPECT_EQ(fresh.at("fresh"), true);
  EXPECT_EQ(fresh.at("rows").at(0).at("first_queries"), 60);
  EXPECT_EQ(fresh.at("rows").at(0).at("wrong"), 0);
  const double first = fresh.at("rows").at(0).at("first_us");
  EXPECT_NEAR(fresh.at("rows").at(0).at("mean_us"), first, 1e-6 * first);
}

TEST_F(BenchCommand, PlansForOtherRobotsAndMovesWithLengthsOfTheirOwn) {
  const std::string file = scenario(kRight);
  const json four = results({file, "--planner", "astar,dijkstra", "--connectivity", "4"});
  EXPECT_EQ(four.at("robot"), "a point, 4 neighbours");
  for (const json& row : four.at("rows")) {
    EXPECT_EQ(row.at("solved"), 2);
    EXPECT_EQ(row.at("wrong"), 0) << "4 + 3 steps, not the 6.41 that the file has";
  }
  const json wide = rows({file, "--planner", "astar,jps", "--robot-radius", "1"});
  for (const json& row : wide) {
    EXPECT_EQ(row.at("solved"), 0) << "both corners are too near to the wall";
    EXPECT_EQ(row.at("wrong"), 0);
  }
  EXPECT_THAT(wend({"bench", file, "--robot-radius", "0.5", "--corner-rule", "one"}).out,
              HasSubstr("Robot: radius 0.5, 8 neighbours, one corner may be cut."));
}

TEST_F(BenchCommand, TakesTerrainAsCosts) {
  folder_.write("rough.txt", ".3.\n#~#\n...\n");
  const auto wrong = [&](const std::string& length) {
    folder_.write("rough.txt.scen", "version 1\n0 rough.txt 3 3 0 0 2 0 " + length + "\n");
    return rows({folder_ / "rough.txt.scen", "--planner", "astar,dijkstra"}).at(0).at("wrong");
  };
  EXPECT_EQ(wrong("4.00000000"), 0);
  EXPECT_EQ(wrong("2.00000000"), 1);
}

TEST_F(BenchCommand, TakesRosMapsWithQueriesInCells) {
  ASSERT_EQ(
      wend({"generate", "office", "--size", "90x80", "--seed", "3", "-o", folder_ / "office.yaml"})
          .code,
      0);
  const std::string file = folder_ / "office.yaml.scen";
  ASSERT_EQ(wend({"generate", "scenario", folder_ / "office.yaml", "--buckets", "5", "--per-bucket",
                  "2", "-o", file})
                .code,
            0);
  for (const std::string radius : {"0", "0.2"}) {
    const json found = rows({file, "--planner", "astar,jps", "--robot-radius", radius});
    for (const json& row : found) {
      EXPECT_EQ(row.at("queries"), 10);
      EXPECT_EQ(row.at("wrong"), 0) << radius;
    }
  }
}

TEST_F(BenchCommand, GivesUpAfterATimeAndDoesNotCountThatAsWrong) {
  wend({"generate", "random", "--size", "300x300", "--seed", "3", "-o", folder_ / "long.map"});
  const std::string file =
      folder_.write("long.map.scen",
                    "version 1\n0 long.map 300 300 0 0 299 299 1\n0 long.map 300 300 0 0 0 0 0\n");
  const json row = rows({file, "--planner", "dijkstra", "--limit-time", "0.00001"}).at(0);
  EXPECT_EQ(row.at("timed_out"), 1);
  EXPECT_EQ(row.at("solved"), 1);
  EXPECT_EQ(row.at("wrong"), 0);
  EXPECT_EQ(results({file, "--limit-time", "2"}).at("limit_s"), 2);
  EXPECT_EQ(wend({"bench", file, "--limit-time", "0"}).code, 2);
}

TEST_F(BenchCommand, WritesEveryQuery) {
  const std::string csv = folder_ / "queries.csv";
  // Twice: the option replaces its own file.
  EXPECT_EQ(wend({"bench", scenario(kRight), "--planner", "astar", "--per-query", csv}).code, 0);
  ASSERT_EQ(wend({"bench", scenario(kRight), "--planner", "astar,bfs", "--per-query", csv}).code,
            0);
  const std::string text = bytes_of(csv);
  EXPECT_THAT(text, StartsWith("scen,line,planner,status,length,"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  EXPECT_THAT(text, HasSubstr(",3,bfs,found,6.41"));
}

}  // namespace
}  // namespace wend::test
