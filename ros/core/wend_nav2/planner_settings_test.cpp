// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/planner_settings.hpp"

#include <gtest/gtest.h>

#include <set>

#include "wend/planner/planners.hpp"

namespace wend_nav2 {
namespace {

TEST(PlannerSettings, NoPlannerHasAnOptionThatIsNamedAsOneOfThePlugin) {
  for (const wend::PlannerInfo& planner : wend::planners()) {
    const PlannerSchema schema = planner_schema(planner.name);
    std::set<std::string> names{std::string(kPlannerParameter), std::string(kPrimitivesParameter)};
    for (const auto& option : schema.plugin) EXPECT_TRUE(names.insert(option.name).second);
    for (const auto& option : schema.planner) {
      EXPECT_TRUE(names.insert(option.name).second) << planner.name << ": " << option.name;
    }
  }
}

TEST(PlannerSettings, TheDefaultsOfEveryPlannerAreTaken) {
  for (const wend::PlannerInfo& planner : wend::planners()) {
    const PlannerSchema schema = planner_schema(planner.name);
    EXPECT_EQ(schema.planner.size(), planner.options.size());
    wend::OptionValues values;
    for (const auto& option : schema.plugin) values.emplace_back(option.name, option.default_value);
    for (const auto& option : schema.planner)
      values.emplace_back(option.name, option.default_value);
    const auto settings = settings_from(planner.name, values);
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_EQ(*settings, (PlannerSettings{.planner = planner.name})) << planner.name;
  }
}

TEST(PlannerSettings, TakesOptionsOfThePluginAndOfThePlanner) {
  const auto settings = settings_from("astar", {{"weight", "1.5"},
                                                {"obstacles", "footprint"},
                                                {"time_limit", "0.25"},
                                                {"allow_unknown", "false"}});
  ASSERT_TRUE(settings) << settings.error().message;
  EXPECT_EQ(settings->options, (wend::OptionValues{{"weight", "1.5"}}));
  EXPECT_EQ(settings->plugin.obstacles, ObstacleRule::footprint);
  EXPECT_EQ(settings->plugin.time_limit, 0.25);
  EXPECT_FALSE(settings->plugin.allow_unknown);
}

TEST(PlannerSettings, SaysWhatIsWrong) {
  const auto message = [](std::string_view planner, const wend::OptionValues& values,
                          std::string_view primitives = {}) {
    const auto settings = settings_from(planner, values, primitives);
    return settings ? std::string("no error") : settings.error().message;
  };
  EXPECT_EQ(message("astra", {}), "there is no planner 'astra': did you mean 'astar'?");
  EXPECT_EQ(message("bfs", {{"weight", "2"}}).substr(0, 23), "unknown option 'weight'");
  EXPECT_EQ(message("astar", {{"weight", "heavy"}}).substr(0, 16), "option 'weight':");
  EXPECT_EQ(message("astar", {{"time_limit", "-1"}}).substr(0, 20), "option 'time_limit':");
  EXPECT_EQ(message("astar", {{"obstacles", "none"}}).substr(0, 19), "option 'obstacles':");
  EXPECT_NE(message("lattice", {}, "no_such.mprim").find("no_such.mprim"), std::string::npos);
  EXPECT_TRUE(planner_schema("astra").planner.empty());
}

TEST(PlannerSettings, RefuseWhatTheSearchWouldRefuse) {
  const auto fault_of = [](const wend::OptionValues& values) {
    const auto settings = settings_from("hybrid_astar", values);
    return settings ? std::string("none") : settings.error().message;
  };
  EXPECT_NE(fault_of({{"turning_radius", "0"}}).find("turning_radius"), std::string::npos);
  EXPECT_EQ(fault_of({{"turning_radius", "0"}, {"motion_model", "differential"}}), "none");
  for (const char* number : {"nan", "-nan", "inf", "-1", "1e300"}) {
    EXPECT_NE(fault_of({{"turning_radius", number}}).find("turning_radius"), std::string::npos)
        << number;
    EXPECT_NE(fault_of({{"time_limit", number}}).find("time_limit"), std::string::npos) << number;
  }
}

}  // namespace
}  // namespace wend_nav2
