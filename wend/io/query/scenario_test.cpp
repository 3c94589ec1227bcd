#include "wend/io/query/scenario.hpp"

#include <gmock/gmock.h>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::EndsWith;

std::string scenario_error(const std::string& line) {
  return error_of(parse_scenario("version 1\n" + line + "\n", "s"));
}

ScenarioQuery query_in(const std::string& line) {
  const auto scenario = parse_scenario("version 1\n" + line + "\n", "s");
  EXPECT_TRUE(scenario) << error_of(scenario);
  return scenario ? scenario->queries.at(0) : ScenarioQuery{};
}

std::string with_length(const std::string& length) {
  return "0\tm.map\t5\t4\t0\t0\t4\t3\t" + length;
}

TEST(Scenario, ReadsEveryColumn) {
  const ScenarioQuery query = query_in("7\tmaps/dao/a.map\t5\t4\t0\t1\t4\t3\t5.24264");
  EXPECT_EQ(query.line, 2U);
  EXPECT_EQ(query.bucket, 7);
  EXPECT_EQ(query.map, "maps/dao/a.map");
  EXPECT_EQ(query.map_width, 5);
  EXPECT_EQ(query.map_height, 4);
  EXPECT_EQ(query.start, (Cell{0, 1}));
  EXPECT_EQ(query.goal, (Cell{4, 3}));
  EXPECT_EQ(query.length, 5.24264);
  EXPECT_EQ(query.decimals, 5);
  EXPECT_FALSE(query.says_no_path());
}

TEST(Scenario, BlanksMaySeparateTheColumns) {
  EXPECT_EQ(query_in("7 a.map  5 4 0 1 4 3 244.95 ").length, 244.95);
}

TEST(Scenario, BetweenTabsAMapMayHaveBlanksInItsName) {
  EXPECT_EQ(query_in("7\tAcross the Cape.map\t5\t4\t0\t1\t4\t3\t6").map, "Across the Cape.map");
}

TEST(Scenario, VersionIsOneOrOnePointZero) {
  const std::string line = with_length("5") + "\r\n";
  EXPECT_TRUE(parse_scenario("version 1\r\n" + line, "s"));
  EXPECT_TRUE(parse_scenario("version 1.0\n" + line, "s"));
  EXPECT_EQ(error_of(parse_scenario("version one\n" + line, "s")),
            "s:1: version 'one' is not a number");
  EXPECT_EQ(error_of(parse_scenario("version 2\nheight 4\n", "s")),
            "s:1: version 2 is not supported, only 1 is");
  EXPECT_EQ(error_of(parse_scenario("", "s")), "s:1: the first line must be 'version 1', not ''");
}

TEST(Scenario, BlankLinesAreSkippedAndCounted) {
  const auto scenario = parse_scenario("version 1\n\n" + with_length("5") + "\n\n", "s");
  ASSERT_TRUE(scenario);
  ASSERT_EQ(scenario->queries.size(), 1U);
  EXPECT_EQ(scenario->queries[0].line, 3U);
}

TEST(Scenario, HasNineColumns) {
  EXPECT_EQ(scenario_error("0\tm.map\t5\t4\t0\t0\t4\t3"), "s:2: 8 columns, expected 9");
  EXPECT_EQ(scenario_error(with_length("5\t6")), "s:2: 10 columns, expected 9");
}

TEST(Scenario, CoordinatesAreWholeNumbers) {
  EXPECT_EQ(scenario_error("0\tm.map\t5\t4\t0.5\t0\t4\t3\t5"),
            "s:2: start x '0.5' is not a whole number in range");
  EXPECT_EQ(scenario_error("0\tm.map\t5\t4\t0\t99999999999\t4\t3\t5"),
            "s:2: start y '99999999999' is not a whole number in range");
}

TEST(Scenario, StartAndGoalLieInTheMap) {
  EXPECT_EQ(scenario_error("0\tm.map\t5\t4\t0\t4\t0\t0\t4"),
            "s:2: start (0,4) is outside the 5x4 map");
  EXPECT_EQ(scenario_error("0\tm.map\t5\t4\t0\t0\t5\t0\t4"),
            "s:2: goal (5,0) is outside the 5x4 map");
  EXPECT_EQ(scenario_error("0\tm.map\t5\t4\t-1\t0\t0\t0\t4"),
            "s:2: start (-1,0) is outside the 5x4 map");
  EXPECT_EQ(scenario_error("0\tm.map\t0\t4\t0\t0\t0\t0\t4"), "s:2: the map size must be positive");
}

TEST(Scenario, LengthsAreFiniteAndNotNegative) {
  for (const std::string length : {"-4", "inf", "nan", "five", "1e999", "4x"}) {
    EXPECT_EQ(scenario_error(with_length(length)),
              "s:2: the length must be finite and at least 0, not '" + length + "'");
  }
}

TEST(Scenario, LengthZeroBetweenDifferentCellsSaysThatThereIsNoPath) {
  EXPECT_TRUE(query_in(with_length("0")).says_no_path());
  EXPECT_FALSE(query_in("0\tm.map\t5\t4\t1\t1\t1\t1\t0").says_no_path());
}

TEST(Scenario, CountsTheDecimalsThatAreThere) {
  EXPECT_EQ(query_in(with_length("5")).decimals, 0);
  EXPECT_EQ(query_in(with_length("5.")).decimals, 0);
  EXPECT_EQ(query_in(with_length("5.20")).decimals, 2);
  EXPECT_EQ(query_in(with_length("5.20000000")).decimals, 8);
  EXPECT_EQ(query_in(with_length("5.2e1")).decimals, 1);
}

TEST(Scenario, MapsOfAnotherSizeAreRefused) {
  const auto scenario = parse_scenario("version 1\n" + with_length("5"), "s");
  EXPECT_TRUE(check_map_size(*scenario, 5, 4));
  EXPECT_EQ(error_of(check_map_size(*scenario, 10, 8)),
            "s:2: the query is for a 5x4 map, the map is 10x8; maps are not scaled");
  EXPECT_FALSE(check_map_size(*scenario, 4, 5));
}

TEST(EvenlySampled, KeepsTheOrderAndSpreadsTheGaps) {
  std::vector<ScenarioQuery> queries(10, query_in(with_length("5")));
  for (std::size_t i = 0; i < queries.size(); ++i) queries[i].line = i;
  const auto lines_of = [&](std::size_t count) {
    std::vector<std::size_t> lines;
    for (const ScenarioQuery& query : evenly_sampled(queries, count)) lines.push_back(query.line);
    return lines;
  };
  EXPECT_EQ(lines_of(4), (std::vector<std::size_t>{0, 2, 5, 7}));
  EXPECT_EQ(lines_of(0), std::vector<std::size_t>{});
  EXPECT_EQ(lines_of(10).size(), 10U);
  EXPECT_EQ(lines_of(11), lines_of(10));
}

TEST(LengthMatches, AllowsOneInAHundredThousand) {
  const ScenarioQuery query = query_in(with_length("1000.5"));
  EXPECT_TRUE(length_matches(query, 1000.5 + 0.01));
  EXPECT_TRUE(length_matches(query, 1000.5 - 0.01));
  EXPECT_FALSE(length_matches(query, 1000.5 + 0.0101));
  EXPECT_FALSE(length_matches(query, 1000.5 - 0.0101));
}

TEST(LengthMatches, AllowsTheRoundingOfTwoDecimals) {
  EXPECT_TRUE(length_matches(query_in(with_length("1.41")), 1.41421356));
  EXPECT_FALSE(length_matches(query_in(with_length("1.41")), 1.4151));
  EXPECT_FALSE(length_matches(query_in(with_length("1.414")), 1.41421356));
  EXPECT_FALSE(length_matches(query_in(with_length("1")), 1.00002));
}

class ScenarioMap : public testing::Test {
 protected:
  std::string map_of(const std::string& name, const std::string& map_column) {
    const auto file =
        folder_.write(name, "version 1\n0\t" + map_column + "\t5\t4\t0\t0\t4\t3\t5\n");
    const auto path = scenario_map_path(load_scenario(file).value());
    return path ? path->lexically_relative(folder_.path()).string() : error_of(path);
  }

  TemporaryFolder folder_;
};

TEST_F(ScenarioMap, IsTheOneThatTheScenarioIsNamedAfter) {
  folder_.write("a.map", "");
  folder_.write("b.map", "");
  EXPECT_EQ(map_of("a.map.scen", "maps/dao/b.map"), "a.map");
}

TEST_F(ScenarioMap, ElseTheOneInTheMapColumnInTheSameFolder) {
  folder_.write("b.map", "");
  EXPECT_EQ(map_of("a.map.scen", "maps/dao/b.map"), "b.map");
  EXPECT_EQ(map_of("a-random-1.scen", "b.map"), "b.map");
  EXPECT_EQ(map_of("a-random-2.scen", "maps\\dao\\b.map"), "b.map");
}

TEST_F(ScenarioMap, IsNeverOutsideTheFolder) {
  EXPECT_THAT(map_of("a.scen", "../../../../etc/passwd"),
              EndsWith("its map 'passwd' is not in the same folder"));
  EXPECT_THAT(map_of("b.scen", ".."), EndsWith("expected one map name in all lines"));
  EXPECT_THAT(map_of("c.scen", "maps/"), EndsWith("expected one map name in all lines"));
}

TEST_F(ScenarioMap, IsTheSameForAllLines) {
  folder_.write("a.map", "");
  const auto file =
      folder_.write("x.scen", "version 1\n0 a.map 1 1 0 0 0 0 0\n0 b.map 1 1 0 0 0 0 0\n");
  EXPECT_THAT(error_of(scenario_map_path(load_scenario(file).value())),
              EndsWith("expected one map name in all lines"));
}

TEST_F(ScenarioMap, ScenariosOfAFolderComeByName) {
  folder_.write("a.map", "");
  EXPECT_THAT(error_of(scenarios_in(folder_.path())),
              EndsWith("the folder contains no .scen file"));
  const auto b = folder_.write("b.scen", "");
  const auto a = folder_.write("a.map.scen", "");
  EXPECT_EQ(scenarios_in(folder_.path()).value(), (std::vector{a, b}));
  EXPECT_FALSE(scenarios_in(folder_.path() / "none"));
}

TEST(Scenario, SkipsAByteOrderMark) {
  const auto scenario = parse_scenario("\xEF\xBB\xBFversion 1\n0 m 2 1 0 0 1 0 1\n", "m.scen");
  EXPECT_EQ(error_of(scenario), "no error");
}

}  // namespace
}  // namespace wend
