#include "wend/planner/planners.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

TEST(PlannerSpec, NamesAloneHaveNoOptions) {
  const auto specs = parse_planner_specs("astar,bfs");
  ASSERT_TRUE(specs.has_value());
  ASSERT_EQ(specs->size(), 2U);
  EXPECT_EQ((*specs)[0].name, "astar");
  EXPECT_TRUE((*specs)[0].options.empty());
  EXPECT_EQ((*specs)[1].name, "bfs");
}

TEST(PlannerSpec, OptionsFollowAColonAndCommas) {
  const auto specs = parse_planner_specs("astar:weight=2,heuristic=euclidean,dfs");
  ASSERT_TRUE(specs.has_value());
  ASSERT_EQ(specs->size(), 2U);
  EXPECT_EQ((*specs)[0].text, "astar:weight=2,heuristic=euclidean");
  EXPECT_EQ((*specs)[0].options, (OptionValues{{"weight", "2"}, {"heuristic", "euclidean"}}));
  EXPECT_EQ((*specs)[1].name, "dfs");
}

TEST(PlannerSpec, WhatIsNoPlannerIsRefusedWithASuggestion) {
  const auto specs = parse_planner_specs("astr");
  ASSERT_FALSE(specs.has_value());
  EXPECT_EQ(specs.error().status, Status::invalid_option);
  EXPECT_NE(specs.error().message.find("'astar'"), std::string::npos) << specs.error().message;
}

TEST(PlannerSpec, EmptyAndHalfWordsAreRefused) {
  for (const char* list : {"", ",", "astar,", "astar:", "astar:weight", "astar:=2", "astar,=2"}) {
    EXPECT_FALSE(parse_planner_specs(list).has_value()) << list;
  }
}

}  // namespace
}  // namespace wend
