#include "bench/scenario/bench_queries.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

TEST(BenchQueries, AreALineAnAnswer) {
  const std::vector<BenchedMap> maps{
      {"astar:weight=2,h=x",
       9,
       {{.line = 2,
         .length = 4,
         .expanded = 5,
         .seconds = {3e-6, 2e-6},
         .first = FirstQuery{.prepare_s = 1e-3, .seconds = 7e-6}},
        {.line = 3, .status = Status::unreachable, .wrong = true, .seconds = {8e-6}}},
       "a.scen"}};
  const std::string names =
      "scen,line,planner,status,length,expanded,wrong,prepare_us,first_us,later_us,passes\n";
  EXPECT_EQ(bench_queries_csv(maps, false),
            names +
                "a.scen,2,\"astar:weight=2,h=x\",found,4,5,0,1000,7,2,2\n"
                "a.scen,3,\"astar:weight=2,h=x\",unreachable,0,0,1,,,8,1\n");
  EXPECT_EQ(bench_queries_csv({}, false), names);
}

TEST(BenchQueries, OfNewPlannersHaveNoLaterTime) {
  const std::vector<BenchedMap> maps{
      {"jps",
       9,
       {{.line = 2, .seconds = {7e-6}, .first = FirstQuery{.prepare_s = 1e-3, .seconds = 7e-6}}},
       "a.scen"}};
  EXPECT_TRUE(bench_queries_csv(maps, true).ends_with("\na.scen,2,jps,found,0,0,0,1000,7,,1\n"));
}

}  // namespace
}  // namespace wend
