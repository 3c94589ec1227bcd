// `wend generate scenario`: queries for a map, which brute force finds right and `wend bench` takes.

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "conformance/reference.hpp"
#include "tests/command_line/run_program.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/query/scenario.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class ScenarioCommand : public testing::Test {
 protected:
  /// A map of a kind.
  std::string map(const std::string& kind, const std::string& file,
                  const std::string& size = "48x40") const {
    const Outcome made =
        wend({"generate", kind, "--size", size, "--seed", "3", "-o", folder_ / file});
    EXPECT_EQ(made.code, 0) << made.err;
    return folder_ / file;
  }

  /// A scenario for it, as it is read back, each query held to brute force.
  Scenario scenario(const std::string& map_file, const std::vector<std::string>& more = {},
                    Robot robot = {}, Rules rules = {}) const {
    const std::string file = map_file + ".scen";
    std::vector<std::string> words{"generate", "scenario", map_file, "-o", file};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome made = wend(words);
    EXPECT_EQ(made.code, 0) << made.err;
    const auto read = load_scenario(file);
    if (!read) throw std::runtime_error(read.error().message);
    const GridMap loaded = load_map(map_file)->map;
    const Reference reference(loaded, robot, rules);
    for (const ScenarioQuery& query : read->queries) {
      const double cost = reference.costs_from(query.start)[reference.number(query.goal)];
      EXPECT_NEAR(cost, query.length, 1e-8) << query.line;
      EXPECT_EQ(query.bucket, static_cast<int>(query.length / 4)) << query.line;
      EXPECT_EQ(query.map, std::filesystem::path(map_file).filename());
      EXPECT_EQ(query.map_width, loaded.width());
      EXPECT_EQ(query.map_height, loaded.height());
    }
    return *read;
  }

  TemporaryFolder folder_;
};

TEST_F(ScenarioCommand, HasTenQueriesInEveryBucketThatBenchFindsRight) {
  const std::string rooms = map("rooms", "rooms.map", "64x64");
  const Scenario made = scenario(rooms, {"--buckets", "10", "--seed", "1"});
  EXPECT_THAT(bytes_of(rooms + ".scen"), StartsWith("version 1\n0\trooms.map\t64\t64\t"));
  std::map<int, int> sizes;
  for (const ScenarioQuery& query : made.queries) ++sizes[query.bucket];
  EXPECT_EQ(sizes.size(), 10U);
  for (const auto& [bucket, size] : sizes) EXPECT_EQ(size, 10) << bucket;
  const Outcome bench =
      wend({"bench", rooms + ".scen", "--planner", "astar,jps", "--format", "json"});
  EXPECT_EQ(bench.code, 0) << bench.err;
  const json rows = json::parse(bench.out).at("rows");
  for (const json& row : rows) EXPECT_EQ(row.at("solved"), 100);
}

TEST_F(ScenarioCommand, IsForTheRobotAndItsMovesThatAreGiven) {
  scenario(map("office", "office.yaml", "90x80"), {"--robot-radius", "0.2", "--per-bucket", "2"},
           {.radius = 2});
  scenario(map("random", "four.map"), {"--connectivity", "4", "--per-bucket", "2"}, {},
           {.diagonals = false});
  scenario(map("random", "cut.map"), {"--corner-rule", "both", "--per-bucket", "2"}, {},
           {.corners_cut = 2});
}

TEST_F(ScenarioCommand, CountsTerrain) {
  const std::string rough = map("rough", "rough.txt", "24x24");
  const Scenario made = scenario(rough, {"--per-bucket", "3"});
  EXPECT_GT(made.queries.size(), 10U);
  EXPECT_EQ(wend({"bench", rough + ".scen", "--planner", "astar,dijkstra"}).code, 0);
}

TEST_F(ScenarioCommand, IsTheSameForTheSameSeed) {
  const std::string rooms = map("rooms", "rooms.map");
  const auto printed = [&](const std::string& seed) {
    return wend({"generate", "scenario", rooms, "--buckets", "3", "--seed", seed}).out;
  };
  EXPECT_THAT(printed("1"), StartsWith("version 1\n"));
  EXPECT_EQ(printed("1"), printed("1"));
  EXPECT_NE(printed("1"), printed("2"));
}

TEST_F(ScenarioCommand, SaysWhatItMade) {
  const std::string rooms = map("rooms", "rooms.map");
  const std::string file = folder_ / "a.scen";
  const Outcome text = wend({"generate", "scenario", rooms, "--buckets", "3", "-o", file});
  EXPECT_EQ(text.out, "30 queries in 3 buckets on " + rooms + ", seed 1\n");
  const json made = json::parse(
      wend({"generate", "scenario", rooms, "--buckets", "3", "--format", "json", "-o", file}).out);
  EXPECT_EQ(made.at("queries"), 30);
  EXPECT_EQ(made.at("buckets"), 3);
  EXPECT_LT(made.at("longest"), 12);
  EXPECT_EQ(made.at("files").at(0), file);
}

TEST_F(ScenarioCommand, RefusesBadInput) {
  const std::string rooms = map("rooms", "rooms.map");
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"generate", "scenario"});
    const Outcome outcome = wend(words);
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_THAT(refused({}), HasSubstr("MAP"));
  EXPECT_THAT(refused({folder_ / "none.map"}), HasSubstr("none.map"));
  EXPECT_THAT(refused({rooms, "--buckets", "0"}), HasSubstr("--buckets 0: must be from 1"));
  EXPECT_THAT(refused({rooms, "--per-bucket", "0"}), HasSubstr("--per-bucket 0: must be from 1"));
  EXPECT_THAT(refused({rooms, "-o", folder_ / "a.map"}), HasSubstr(".scen"));
  const std::string walls = folder_.write("walls.txt", "#.#\n###\n");
  EXPECT_THAT(refused({walls}), HasSubstr("no two cells are connected"));
}

TEST_F(ScenarioCommand, LeavesTheKindsOfMapsAsTheyWere) {
  EXPECT_THAT(wend({"generate"}).err, HasSubstr("needs a KIND"));
  EXPECT_EQ(wend({"generate"}).code, 2);
  EXPECT_EQ(wend({"generate", "maze", "--size", "11x11"}).code, 0);
}

}  // namespace
}  // namespace wend::test
