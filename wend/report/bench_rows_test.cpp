#include "wend/report/bench_rows.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Answers that took so many microseconds, one pass each.
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
  answers[1].seconds = {6e-6, 10e-6, 1e-6};  // the third pass was cut short
  BenchRow row;
  row.set_answers(answers);
  EXPECT_DOUBLE_EQ(row.mean_us, 1.5);
  EXPECT_EQ(row.passes, 2);
  EXPECT_DOUBLE_EQ(row.fastest_pass_us, 5);
  EXPECT_DOUBLE_EQ(row.slowest_pass_us, 6);
  EXPECT_DOUBLE_EQ(row.spread(), 0.2);
}

TEST(BenchRows, AreJson) {
  const std::vector<BenchRow> rows{{.scen = "a.scen", .planner = "astar", .queries = 3},
                                   {.scen = "b.scen", .planner = "bfs", .wrong = 2}};
  const auto json = nlohmann::json::parse(bench_json(rows));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json.at(0).at("queries"), 3);
  EXPECT_EQ(json.at(1).at("wrong"), 2);
}

TEST(BenchRows, AreCsv) {
  const std::vector<BenchRow> rows{{.scen = "a,b.scen", .planner = "astar", .mean_us = 0.5}};
  EXPECT_EQ(bench_csv(rows),
            "scen,planner,queries,solved,wrong,mean_us,median_us,p99_us,expanded_per_query,"
            "expansions_per_second,threads,passes,fastest_pass_us,slowest_pass_us,spread,build_s,"
            "index_bytes\n"
            "\"a,b.scen\",astar,0,0,0,0.5,0,0,0,0,1,0,0,0,0,0,0\n");
}

TEST(BenchRows, AreATableWithWhatThereIs) {
  std::vector<BenchRow> rows{{.scen = "a.scen", .planner = "astar", .passes = 1}};
  EXPECT_THAT(bench_table(rows), StartsWith("scenario  planner  queries"));
  EXPECT_THAT(bench_table(rows), Not(HasSubstr("spread")));
  EXPECT_THAT(bench_table(rows), Not(HasSubstr("index")));
  rows.push_back({.scen = "a.scen",
                  .planner = "labels",
                  .build_s = 2.5,
                  .index_bytes = 12'340'000,
                  .mean_us = 0.4321,
                  .passes = 3,
                  .fastest_pass_us = 1,
                  .slowest_pass_us = 1.25});
  const std::string table = bench_table(rows);
  EXPECT_THAT(table, HasSubstr("25.0 %"));
  EXPECT_THAT(table, HasSubstr("12.34"));
  EXPECT_THAT(table, HasSubstr("0.432"));
}

}  // namespace
}  // namespace wend
