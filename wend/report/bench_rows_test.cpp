#include "wend/report/bench_rows.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numeric>

namespace wend {
namespace {

TEST(BenchRow, SumsUpItsWork) {
  std::vector<double> microseconds(100);
  std::iota(microseconds.rbegin(), microseconds.rend(), 1.0);  // 100, 99, ..., 1
  BenchRow row;
  row.set_work(microseconds, 5050);
  EXPECT_DOUBLE_EQ(row.mean_us, 50.5);
  EXPECT_EQ(row.median_us, 50);
  EXPECT_EQ(row.p99_us, 99);
  EXPECT_EQ(row.expanded_per_query, 50.5);
  EXPECT_DOUBLE_EQ(row.expansions_per_second, 1e6);
}

TEST(BenchRow, OneQueryIsEveryQuantile) {
  BenchRow row;
  row.set_work({7}, 14);
  EXPECT_EQ(row.median_us, 7);
  EXPECT_EQ(row.p99_us, 7);
}

TEST(BenchRow, NoQueriesAndNoTimeDivideByNothing) {
  BenchRow row;
  row.set_work({}, 0);
  EXPECT_EQ(row.mean_us, 0);
  row.set_work({0, 0}, 0);
  EXPECT_EQ(row.expansions_per_second, 0);
}

TEST(BenchRows, AreJsonAndATable) {
  const std::vector<BenchRow> rows{{.scen = "a.scen", .planner = "astar", .queries = 3},
                                   {.scen = "b.scen", .planner = "bfs", .wrong = 2}};
  const auto json = nlohmann::json::parse(bench_json(rows));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json.at(0).at("queries"), 3);
  EXPECT_EQ(json.at(1).at("wrong"), 2);
  EXPECT_THAT(bench_table(rows), testing::StartsWith("scenario  planner  queries"));
}

}  // namespace
}  // namespace wend
