#include "bench/scenario/bench_rows.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Answers that took these times, one repetition each.
std::vector<BenchAnswer> answers_in(const std::vector<double>& microseconds) {
  std::vector<BenchAnswer> answers;
  for (const double time : microseconds) {
    answers.push_back({.line = answers.size() + 2, .expanded = 7, .seconds = {time * 1e-6}});
  }
  return answers;
}

TEST(BenchRow, SumsUpItsAnswers) {
  std::vector<double> microseconds;
  for (int i = 100; i > 0; --i) microseconds.push_back(i);
  std::vector<BenchAnswer> answers = answers_in(microseconds);
  answers[3].wrong = true;
  answers[4].status = Status::unreachable;
  BenchRow row;
  row.set_answers(answers);
  EXPECT_EQ(row.queries, 100);
  EXPECT_EQ(row.solved, 99);
  EXPECT_EQ(row.wrong, 1);
  EXPECT_DOUBLE_EQ(row.mean_us, 50.5);
  EXPECT_DOUBLE_EQ(row.median_us, 50);
  EXPECT_DOUBLE_EQ(row.p99_us, 99);
  EXPECT_EQ(row.expanded_per_query, 7);
  EXPECT_DOUBLE_EQ(row.expansions_per_second, 7e6 / 50.5);
  EXPECT_EQ(row.passes, 1);
  EXPECT_EQ(row.spread(), 0);
}

TEST(BenchRow, OneQueryIsEveryQuantile) {
  BenchRow row;
  row.set_answers(answers_in({7}));
  EXPECT_DOUBLE_EQ(row.median_us, 7);
  EXPECT_DOUBLE_EQ(row.p99_us, 7);
}

TEST(BenchRow, NoAnswersAndNoTimeDivideByNothing) {
  BenchRow row;
  row.set_answers({});
  EXPECT_EQ(row.mean_us, 0);
  EXPECT_EQ(row.spread(), 0);
  row.set_answers(answers_in({0, 0}));
  EXPECT_EQ(row.expansions_per_second, 0);
  EXPECT_EQ(row.spread(), 0);
}

TEST(BenchRow, TakesTheFastestPassOfEveryQueryAndShowsTheSpreadOfThePasses) {
  std::vector<BenchAnswer> answers(2);
  answers[0].seconds = {4e-6, 2e-6};
  answers[1].seconds = {6e-6, 10e-6, 1e-6};  // the third repetition was cut short
  BenchRow row;
  row.set_answers(answers);
  EXPECT_DOUBLE_EQ(row.mean_us, 1.5);
  EXPECT_EQ(row.passes, 2);
  EXPECT_DOUBLE_EQ(row.fastest_pass_us, 5);
  EXPECT_DOUBLE_EQ(row.slowest_pass_us, 6);
  EXPECT_DOUBLE_EQ(row.spread(), 0.2);
}

TEST(BenchRow, TellsFirstQueriesFromLaterOnes) {
  std::vector<BenchAnswer> answers = answers_in({2, 4, 6});
  answers[0].first = FirstQuery{.prepare_s = 1e-3, .seconds = 10e-6};
  answers[2].first = FirstQuery{.prepare_s = 3e-3, .seconds = 30e-6};
  BenchRow row;
  row.build_s = 0.5;
  row.set_answers(answers);
  EXPECT_EQ(row.first_queries, 2);
  EXPECT_DOUBLE_EQ(row.prepare_us, 2000);
  EXPECT_DOUBLE_EQ(row.first_us, 20);
  EXPECT_DOUBLE_EQ(row.mean_us, 4);
  EXPECT_DOUBLE_EQ(row.prepare_ms(), 502) << "with the index";
}

TEST(BenchRow, CountsWhatRanOutOfTime) {
  std::vector<BenchAnswer> answers = answers_in({2, 4});
  answers[1].status = Status::time_limit;
  BenchRow row;
  row.set_answers(answers);
  EXPECT_EQ(row.solved, 1);
  EXPECT_EQ(row.timed_out, 1);
}

const BenchConditions kConditions{.version = "0.2.0",
                                  .commit = "0123abc",
                                  .machine = "a processor",
                                  .robot = "a point, 8 neighbours, no corner cutting"};

TEST(BenchRows, AreJson) {
  const std::vector<BenchRow> rows{{.scen = "a.scen", .planner = "astar", .queries = 3},
                                   {.scen = "b.scen", .planner = "bfs", .wrong = 2}};
  const auto json = nlohmann::json::parse(bench_json(kConditions, rows));
  EXPECT_TRUE(json.at("schema").is_number_integer());
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("version"), "0.2.0");
  EXPECT_EQ(json.at("commit"), "0123abc");
  EXPECT_EQ(json.at("times"), "CPU time");
  EXPECT_EQ(json.at("fresh"), false);
  EXPECT_TRUE(json.at("limit_s").is_null());
  ASSERT_EQ(json.at("rows").size(), 2U);
  EXPECT_EQ(json.at("rows").at(0).at("queries"), 3);
  EXPECT_EQ(json.at("rows").at(1).at("wrong"), 2);
}

TEST(BenchRows, AreCsv) {
  const std::vector<BenchRow> rows{{.scen = "a,b.scen", .planner = "astar", .mean_us = 0.5}};
  EXPECT_EQ(bench_csv(kConditions, rows),
            "scen,planner,queries,solved,timed_out,wrong,prepare_us,first_queries,first_us,mean_us,"
            "median_us,p99_us,expanded_per_query,expansions_per_second,threads,passes,"
            "fastest_pass_us,slowest_pass_us,spread,build_s,index_bytes,fresh,version,commit\n"
            "\"a,b.scen\",astar,0,0,0,0,0,0,0,0.5,0,0,0,0,1,0,0,0,0,0,0,false,0.2.0,0123abc\n");
}

/// A row of the greatest width.
BenchRow wide_row(const std::string& planner) {
  return {.scen = "maps/sets/random512-35-0.map.scen",
          .planner = planner,
          .build_s = 15.1,
          .index_bytes = 103'000'000,
          .queries = 1000,
          .solved = 1000,
          .prepare_us = 1500,
          .first_us = 123'456.7,
          .mean_us = 12'345.6,
          .median_us = 12'345.6,
          .p99_us = 123'456.7,
          .expanded_per_query = 123'456.7,
          .passes = 1};
}

TEST(BenchTable, HasTheRowsOfAScenarioBelowItsName) {
  std::vector<BenchRow> rows{wide_row("astar"), wide_row("jps"), wide_row("astar")};
  rows[2].scen = "maps/other.scen";
  EXPECT_EQ(bench_table(kConditions, rows),
            "CPU time of the thread, in microseconds a query.\n"
            "First query: one run of a new planner. Later: least of the runs that fill 5 ms.\n"
            "Robot: a point, 8 neighbours, no corner cutting.\n"
            "Scenarios in maps/.\n"
            "\n"
            "         prepare   first    later                            index\n"
            "planner       ms   query  queries  median    99 %  expanded     MB\n"
            "sets/random512-35-0.map.scen: 1000 queries\n"
            "  astar    15102  123457    12346   12346  123457    123457  103.0\n"
            "  jps      15102  123457    12346   12346  123457    123457  103.0\n"
            "other.scen: 1000 queries\n"
            "  astar    15102  123457    12346   12346  123457    123457  103.0\n");
}

TEST(BenchTable, FitsEightyColumns) {
  std::vector<BenchRow> rows{wide_row("euclidean_labels"),
                             wide_row("astar:weight=2,heuristic=euclidean")};
  rows[0].solved = 997;
  rows[0].timed_out = 3;
  rows[0].wrong = 12;
  rows[0].passes = 3;
  rows[0].fastest_pass_us = 100;
  rows[0].slowest_pass_us = 125;
  rows[1].solved = 990;
  const std::string table = bench_table(kConditions, rows);
  std::size_t begin = 0;
  for (std::size_t end = table.find('\n'); end != std::string::npos;
       end = table.find('\n', begin)) {
    EXPECT_LE(end - begin, 80U) << table.substr(begin, end - begin);
    begin = end + 1;
  }
  EXPECT_THAT(table, HasSubstr("\n    12 wrong, 3 timed out, 3 repetitions, spread 25.0 %\n"));
  EXPECT_THAT(table, HasSubstr("\n  astar:weight=2,heuristic=euclidean\n"));
  EXPECT_THAT(table, HasSubstr("\n    10 without a path\n"));
}

TEST(BenchTable, HasLongNamesBesideTheirNumbersInAWideTerminal) {
  const std::vector<BenchRow> rows{wide_row("astar:weight=2,heuristic=euclidean")};
  const std::string table = bench_table(kConditions, rows, 98);
  EXPECT_THAT(table, HasSubstr("\n  astar:weight=2,heuristic=euclidean    15102  123457"));
  EXPECT_THAT(bench_table(kConditions, rows, 97),
              HasSubstr("\n  astar:weight=2,heuristic=euclidean\n"));
}

TEST(BenchTable, OfNewPlannersHasNoLaterQueries) {
  BenchConditions fresh = kConditions;
  fresh.fresh = true;
  fresh.limit_s = 0.5;
  const std::vector<BenchRow> rows{
      {.scen = "a.scen", .planner = "jps", .queries = 1, .solved = 1, .mean_us = 0.4321}};
  const std::string table = bench_table(fresh, rows);
  EXPECT_THAT(table, HasSubstr("Every query is one run of a new planner."));
  EXPECT_THAT(table, HasSubstr("A query may take 0.5 s."));
  EXPECT_THAT(table, Not(HasSubstr("later")));
  EXPECT_THAT(table, HasSubstr("a.scen: 1 query\n"));
  EXPECT_THAT(table, HasSubstr("0.432"));
  EXPECT_THAT(table, Not(HasSubstr("index")));
}

}  // namespace
}  // namespace wend
