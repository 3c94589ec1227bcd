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

PlannerResult refuse_every_space(const FreeSpace& /*space*/, const OptionValues& /*options*/) {
  return failure(Status::unsupported_map, "it plans nowhere");
}

// What can be added is for the whole program: tests/threads/added_planners_test.cpp and
// tests/command_line/plugin_test.cpp, whose programs list no planners.
TEST(AddPlanners, NamesThatAreTakenOrInvalidAreRefused) {
  for (const char* name : {"", "astar", "A", "a-b", "1a", "_a", "a:b", "ä"}) {
    const auto added = add_planners({{.name = name, .make = refuse_every_space}});
    ASSERT_FALSE(added.has_value()) << name;
    EXPECT_EQ(added.error().status, Status::invalid_option);
    EXPECT_EQ(added.error().where, name);
    EXPECT_NE(added.error().message.find("'" + std::string(name) + "'"), std::string::npos);
  }
}

TEST(AddPlanners, OneThatCannotBeMadeIsRefused) {
  EXPECT_FALSE(add_planners({{.name = "fresh"}}).has_value());
  EXPECT_EQ(planners().find("fresh"), nullptr);
}

TEST(AddPlanners, IfOneIsRefusedNoneIsAdded) {
  const std::size_t before = planners().size();
  const PlannerInfo fresh{.name = "fresh", .make = refuse_every_space};
  EXPECT_FALSE(add_planners({fresh, {.name = "jps", .make = refuse_every_space}}).has_value());
  EXPECT_FALSE(add_planners({fresh, fresh}).has_value()) << "twice the same name";
  EXPECT_EQ(planners().size(), before);
}

}  // namespace
}  // namespace wend
