#include "wend/report/plan_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace wend {
namespace {

using nlohmann::json;

constexpr Frame kFrame{.resolution = 0.5, .origin = {-1, 2, 0}, .y_up = true, .metric = true};

TEST(PlanJson, HasAPlanInCellsAndMetres) {
  PlanResult result{.planner = "astar", .plan = {}, .seconds = 1.5e-6, .reason = {}};
  result.plan.path = Path({{0, 0}, {1, 0}});
  result.plan.cost = 1;
  result.plan.bound = 1;
  result.plan.metrics = {.expanded = 2, .generated = 5, .max_frontier = 3};
  EXPECT_EQ(plan_json(result, kFrame),
            R"({"planner":"astar","status":"found","cost":1.0,"length_cells":1.0,"length_m":0.5,)"
            R"("path":[[0,0],[1,0]],"path_m":[[-0.75,2.25],[-0.25,2.25]],"bound":1.0,)"
            R"("metrics":{"expanded":2,"generated":5,"max_frontier":3,"time_us":1.5}})"
            "\n");
}

TEST(PlanJson, NeverHoldsNumbersThatAreNone) {
  PlanResult result{
      .planner = "dfs", .status = Status::unreachable, .plan = {}, .reason = "too far"};
  result.plan.cost = std::numeric_limits<double>::infinity();
  const json failed = json::parse(plan_json(result, kFrame));
  EXPECT_EQ(failed.at("status"), "unreachable");
  EXPECT_EQ(failed.at("reason"), "too far");
  EXPECT_TRUE(failed.at("cost").is_null());
  EXPECT_TRUE(failed.at("bound").is_null());
  EXPECT_TRUE(failed.at("length_cells").is_null());
  EXPECT_EQ(failed.at("path"), json::array());
  EXPECT_EQ(failed.at("path_m"), json::array());
}

TEST(PlanJson, StaysUtf8WhateverTheReasonHolds) {
  PlanResult result{.planner = "dfs", .status = Status::cancelled, .plan = {}, .reason = "\xff!"};
  EXPECT_EQ(json::parse(plan_json(result, kFrame)).at("reason"), "\xef\xbf\xbd!");
}

}  // namespace
}  // namespace wend
