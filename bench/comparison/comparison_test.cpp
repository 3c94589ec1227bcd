#include "bench/comparison/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Frame kMetric{.resolution = 0.5, .metric = true};

const ComparisonRow kAStar{.planner = "astar",
                           .cost = 10.25,
                           .length = 10.25,
                           .turning = 90,
                           .largest_curvature = 0.5,
                           .smallest_clearance = 1.5,
                           .mean_clearance = 3,
                           .expanded = 120,
                           .generated = 200,
                           .max_frontier = 80,
                           .times = {2e-6, 45.67e-6, 12.34e-6}};
const ComparisonRow kGreedy{.planner = "greedy",
                            .cost = 14,
                            .length = 14,
                            .turning = 270,
                            .largest_curvature = 1,
                            .smallest_clearance = 2,
                            .mean_clearance = 2.5,
                            .expanded = 20,
                            .generated = 60,
                            .max_frontier = 40,
                            .times = {1e-6, 6e-6, 3e-6}};
const ComparisonRow kLost{.planner = "random_walk",
                          .status = Status::step_limit,
                          .reason = "the walk used up its steps",
                          .cost = kInfinity,
                          .length = 0,
                          .smallest_clearance = kInfinity,
                          .expanded = 3,
                          .generated = 4,
                          .max_frontier = 1,
                          .times = {0.5e-6, 2e-6, 1e-6}};

Comparison of_one(std::vector<ComparisonRow> rows, const Frame& frame = {}) {
  return {frame, {{pose_at({1, 2}), {pose_at({3, 4})}, std::move(rows)}}};
}

std::string tabled(const Comparison& comparison) { return "\n" + comparison_table(comparison); }

TEST(ComparisonTable, OfOneQueryHasALineForEachPlanner) {
  EXPECT_EQ(tabled(of_one({kAStar, kGreedy, kLost})), R"(
                                                                     mean
                     length   turning   curvature   clearance   clearance
planner       cost    cells   degrees     1/cells       cells       cells
astar        10.25*   10.25*       90*       0.50*       1.50        3.00*
greedy       14.00    14.00       270        1.00        2.00*       2.50
random_walk      -        -         -           -           -           -

                                                         first     later
                                               prepare   query   queries
planner      expanded   generated   frontier        us      us        us
astar             120         200         80       2.0    45.7      12.3
greedy             20*         60*        40*      1.0*    6.0*      3.0*
random_walk         3           4          1       0.5     2.0       1.0
random_walk: step_limit: the walk used up its steps
* best of its column
Curvatures and turning radii: corners are rounded within 0.1 cells.
Times are CPU time. prepare: to make the planner for the map. first query: one
run of a planner just made. later queries: the quickest of runs that fill 5 ms.
)");
}

TEST(ComparisonTable, HasMetresWherePeopleMeanMetres) {
  EXPECT_EQ(tabled(of_one({kAStar}, kMetric)), R"(
                                                            mean
                length  turning  curvature  clearance  clearance
planner   cost       m  degrees        1/m          m          m
astar    10.25    5.12       90       1.00       0.75       1.50

                                                 first    later
                                        prepare  query  queries
planner  expanded  generated  frontier       us     us       us
astar         120        200        80      2.0   45.7     12.3
Curvatures and turning radii: corners are rounded within 0.1 cells.
Times are CPU time. prepare: to make the planner for the map. first query: one
run of a planner just made. later queries: the quickest of runs that fill 5 ms.
)");
}

TEST(ComparisonTable, OfOneQueryFitsIntoEightyColumns) {
  Comparison comparison = of_one({kAStar, kGreedy, kLost}, kMetric);
  comparison.capabilities.headings = true;
  comparison.queries[0].rows[0].planner = "car:weight=2";
  comparison.queries[0].rows[0].cost = 12345.67;
  std::istringstream lines(comparison_table(comparison));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(ComparisonTable, MarksNothingThatNobodyIsBestIn) {
  EXPECT_THAT(comparison_table(of_one({kAStar})), testing::Not(HasSubstr("*")));
  EXPECT_THAT(comparison_table(of_one({kAStar, kLost})), testing::Not(HasSubstr("*")));
  EXPECT_THAT(comparison_table(of_one({kAStar, kAStar})), testing::Not(HasSubstr("*")));
  EXPECT_THAT(comparison_table(of_one({kLost, kLost})), testing::Not(HasSubstr("*")));
}

TEST(ComparisonTable, HasStepsAndReversalsOfACar) {
  Comparison comparison = of_one({kAStar, kLost});
  comparison.capabilities.headings = true;
  comparison.queries[0].rows[0].steps = 12;
  comparison.queries[0].rows[0].reversals = 3;
  EXPECT_THAT(comparison_table(comparison), HasSubstr(" 1/cells  steps  reversals"));
  EXPECT_THAT(comparison_table(comparison), HasSubstr("      0.50     12          3"));
  comparison.queries.push_back(comparison.queries[0]);
  comparison.queries[0].rows.pop_back();
  comparison.queries[1].rows.pop_back();
  EXPECT_THAT(comparison_table(comparison), HasSubstr("reversals           astar         3"));
}

TEST(ComparisonTable, OfNothingSaysSo) { EXPECT_EQ(comparison_table({}), "no queries\n"); }

/// Twice the same query.
Comparison of_two(std::vector<ComparisonRow> rows, const Frame& frame = {}) {
  Comparison comparison = of_one(std::move(rows), frame);
  comparison.queries.push_back(comparison.queries.front());
  return comparison;
}

TEST(ComparisonTable, OfManyQueriesHasABlockForEachMeasure) {
  EXPECT_EQ(tabled(of_two({kAStar, kGreedy}, kMetric)), R"(
2 queries

planner  solved
astar        2
greedy       2

Of the 2 that every planner solved:

measure            planner  median    mean    99 %
cost / least       astar     1.000*  1.000*  1.000*
                   greedy    1.366   1.366   1.366

length, m          astar      5.12*   5.12*   5.12*
                   greedy     7.00    7.00    7.00

turning, degrees   astar        90*     90*     90*
                   greedy      270     270     270

curvature, 1/m     astar      1.00*   1.00*   1.00*
                   greedy     2.00    2.00    2.00

expanded           astar       120     120     120
                   greedy       20*     20*     20*

generated          astar       200     200     200
                   greedy       60*     60*     60*

frontier           astar        80      80      80
                   greedy       40*     40*     40*

prepare, us        astar       2.0     2.0     2.0
                   greedy      1.0*    1.0*    1.0*

first query, us    astar      45.7    45.7    45.7
                   greedy      6.0*    6.0*    6.0*

later queries, us  astar      12.3    12.3    12.3
                   greedy      3.0*    3.0*    3.0*

measure            planner  median   mean   1 % least
turning radius, m  astar      1.00*  1.00*       1.00*
                   greedy     0.50   0.50        0.50

clearance, m       astar      0.75   0.75        0.75
                   greedy     1.00*  1.00*       1.00*

mean clearance, m  astar      1.50*  1.50*       1.50*
                   greedy     1.25   1.25        1.25

* best of the planners
99 %: what 99 of 100 queries do not exceed. 1 % least: what 99 of 100 reach.
Curvatures and turning radii: corners are rounded within 0.1 cells.
Times are CPU time. prepare: to make the planner for the map. first query: one
run of a planner just made. later queries: the quickest of runs that fill 5 ms.
)");
}

TEST(ComparisonTable, HasNoMeanOfWhatIsInfinite) {
  ComparisonRow straight = kAStar;
  straight.largest_curvature = 0;
  const std::string table = comparison_table(of_two({straight, kGreedy}));
  EXPECT_THAT(table, HasSubstr("turning radius, cells  astar       inf*     -         inf*\n"
                               "                       greedy     1.00   1.00        1.00\n"));
  EXPECT_THAT(table, HasSubstr("\n- there is no mean: some of the values are infinite\n"));
}

TEST(ComparisonTable, OfManyQueriesComparesWhatEveryPlannerSolved) {
  EXPECT_EQ(tabled(of_two({kAStar, kLost})), R"(
2 queries

planner      solved
astar            2*
random_walk      0

No query was solved by every planner: nothing to compare.

* best of the planners
)");
  Comparison comparison = of_two({kAStar, kGreedy});
  comparison.queries.push_back(of_one({kAStar, kLost}).queries.front());
  comparison.queries.back().rows.front().times.later = 100;
  EXPECT_THAT(comparison_table(comparison), HasSubstr("Of the 2 that every planner solved:"));
  EXPECT_THAT(comparison_table(comparison), HasSubstr("astar        3*\n"));
  EXPECT_THAT(comparison_table(comparison), HasSubstr("astar      12.3    12.3    12.3"));
}

TEST(ComparisonJson, HasEveryRow) {
  const json read = json::parse(comparison_json(of_one({kAStar, kLost}, kMetric)));
  const json& query = read.at("queries").at(0);
  EXPECT_EQ(query.at("start"), json({1, 2}));
  EXPECT_EQ(query.at("goal"), json({3, 4}));
  EXPECT_EQ(query.at("planners").at(0), json::parse(R"({
      "planner": "astar", "status": "found", "cost": 10.25, "length_cells": 10.25,
      "length_m": 5.125, "turning_degrees": 90, "curvature_per_cell": 0.5,
      "curvature_per_m": 1, "turning_radius_cells": 2, "turning_radius_m": 1,
      "clearance_cells": 1.5, "clearance_m": 0.75, "mean_clearance_cells": 3,
      "mean_clearance_m": 1.5,
      "metrics": {"expanded": 120, "generated": 200, "max_frontier": 80},
      "times": {"preparation_us": 2, "first_query_us": 45.67, "later_query_us": 12.34}})"));
  EXPECT_EQ(query.at("planners").at(1), json::parse(R"({
      "planner": "random_walk", "status": "step_limit", "reason": "the walk used up its steps",
      "cost": null, "length_cells": null, "length_m": null, "turning_degrees": null,
      "curvature_per_cell": null, "curvature_per_m": null, "turning_radius_cells": null,
      "turning_radius_m": null, "clearance_cells": null, "clearance_m": null,
      "mean_clearance_cells": null, "mean_clearance_m": null,
      "metrics": {"expanded": 3, "generated": 4, "max_frontier": 1},
      "times": {"preparation_us": 0.5, "first_query_us": 2, "later_query_us": 1}})"));
  EXPECT_EQ(read.at("solved_by_all"), 0);
  EXPECT_EQ(read.at("statistics").at(1).at("solved"), 0);
  EXPECT_TRUE(read.at("statistics").at(1).at("expanded").at("mean").is_null());
}

/// A drive, with and without a heading at its goal.
Comparison of_a_car(std::vector<ComparisonRow> rows) {
  rows.front().steps = 12;
  rows.front().reversals = 3;
  Comparison comparison{kMetric, {}, {.headings = true}};
  comparison.queries.push_back({{1, 2, 0}, {Pose{3.5, 4, -kPi / 2}}, rows});
  comparison.queries.push_back({{1, 2, 0.25}, {Goal(Point{3, 4})}, rows});
  return comparison;
}

TEST(ComparisonJson, HasHeadingsStepsAndReversalsOfACar) {
  const json read = json::parse(comparison_json(of_a_car({kAStar, kLost})));
  EXPECT_EQ(read.at("queries").at(0).at("start"), json({1, 2, "E"}));
  EXPECT_EQ(read.at("queries").at(0).at("goal"), json({3.5, 4, "N"}));
  EXPECT_EQ(read.at("queries").at(1).at("start"), json({1, 2, 0.25}));
  EXPECT_EQ(read.at("queries").at(1).at("goal"), json({3, 4, "any"}));
  const json& rows = read.at("queries").at(0).at("planners");
  EXPECT_EQ(rows.at(0).at("steps"), 12);
  EXPECT_EQ(rows.at(0).at("reversals"), 3);
  EXPECT_TRUE(rows.at(1).at("steps").is_null());
  EXPECT_TRUE(read.at("statistics").at(0).contains("reversals"));
}

TEST(ComparisonJson, IsOneLine) {
  const std::string text = comparison_json(of_two({kAStar, kGreedy}));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(json::parse(comparison_json({})),
            json::parse(R"({"schema": 1, "queries": [], "solved_by_all": 0, "statistics": []})"));
}

TEST(ComparisonCsv, HasALineForEachQueryAndPlanner) {
  ComparisonRow open_map = kGreedy;
  open_map.planner = "greedy:a=1,b=\"2\"";
  open_map.smallest_clearance = kInfinity;
  EXPECT_EQ("\n" + comparison_csv(of_one({kAStar, open_map, kLost}, kMetric)), R"(
start_x,start_y,goal_x,goal_y,planner,status,cost,length_cells,length_m,turning_degrees,curvature_per_cell,curvature_per_m,turning_radius_cells,turning_radius_m,clearance_cells,clearance_m,mean_clearance_cells,mean_clearance_m,expanded,generated,max_frontier,preparation_us,first_query_us,later_query_us,reason
1,2,3,4,astar,found,10.25,10.25,5.125,90,0.5,1,2,1,1.5,0.75,3,1.5,120,200,80,2,45.67,12.34,
1,2,3,4,"greedy:a=1,b=""2""",found,14,14,7,270,1,2,1,0.5,inf,inf,2.5,1.25,20,60,40,1,6,3,
1,2,3,4,random_walk,step_limit,,,,,,,,,,,,,3,4,1,0.5,2,1,the walk used up its steps
)");
}

TEST(ComparisonCsv, HasHeadingsStepsAndReversalsOfACar) {
  EXPECT_EQ("\n" + comparison_csv(of_a_car({kAStar})), R"(
start_x,start_y,start_heading,goal_x,goal_y,goal_heading,planner,status,cost,length_cells,length_m,turning_degrees,curvature_per_cell,curvature_per_m,turning_radius_cells,turning_radius_m,steps,reversals,clearance_cells,clearance_m,mean_clearance_cells,mean_clearance_m,expanded,generated,max_frontier,preparation_us,first_query_us,later_query_us,reason
1,2,E,3.5,4,N,astar,found,10.25,10.25,5.125,90,0.5,1,2,1,12,3,1.5,0.75,3,1.5,120,200,80,2,45.67,12.34,
1,2,0.25,3,4,any,astar,found,10.25,10.25,5.125,90,0.5,1,2,1,12,3,1.5,0.75,3,1.5,120,200,80,2,45.67,12.34,
)");
}

double nth_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  std::size_t count = 1;  // of values that are no larger than the last one of them
  while (static_cast<double>(count) < share * static_cast<double>(values.size())) ++count;
  return values[count - 1];
}

ComparisonRow random_row(Random& random, const std::string& planner) {
  ComparisonRow row{.planner = planner, .expanded = random.below(1000)};
  row.cost = row.length = random.between(10, 40);
  row.smallest_clearance = random.between(1, 9) / 2.0;
  row.times = {random.uniform(), random.uniform(), random.uniform()};
  if (random.chance(0.1)) row.status = Status::unreachable;
  return row;
}

RC_GTEST_PROP(ComparisonJson, StatisticsAreThoseOfTheQueriesThatAllSolved, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  Comparison comparison;
  std::vector<double> expanded;
  std::vector<double> ratios;
  std::vector<double> worse_clearances;
  for (int i = random.between(1, 120); i > 0; --i) {
    const ComparisonRow a = random_row(random, "a");
    const ComparisonRow b = random_row(random, "b");
    comparison.queries.push_back({pose_at({0, 0}), {pose_at({1, 1})}, {a, b}});
    if (!a.found() || !b.found()) continue;
    expanded.push_back(static_cast<double>(a.expanded));
    ratios.push_back(a.cost / std::min(a.cost, b.cost));
    worse_clearances.push_back(-a.smallest_clearance);
  }
  RC_PRE(!expanded.empty());
  const json read = json::parse(comparison_json(comparison));
  RC_ASSERT(read.at("solved_by_all") == expanded.size());
  const json& statistics = read.at("statistics").at(0);
  RC_ASSERT(statistics.at("expanded").at("median") == nth_of(expanded, 0.5));
  RC_ASSERT(statistics.at("expanded").at("p99") == nth_of(expanded, 0.99));
  RC_ASSERT(statistics.at("cost_ratio").at("p99") == nth_of(ratios, 0.99));
  RC_ASSERT(statistics.at("clearance_cells").at("p1") == -nth_of(worse_clearances, 0.99));
  double sum = 0;
  for (const double value : expanded) sum += value;
  const double mean = sum / static_cast<double>(expanded.size());
  RC_ASSERT(std::abs(statistics.at("expanded").at("mean").get<double>() - mean) <= 1e-9 * mean);
}

}  // namespace
}  // namespace wend
