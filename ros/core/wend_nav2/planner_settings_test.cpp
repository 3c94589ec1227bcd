// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/planner_settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "tests/testing/build_paths.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/robot_fields.hpp"

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
  EXPECT_EQ(settings->request["time_limit"], 0.25);
  EXPECT_FALSE(settings->plugin.allow_unknown);
}

TEST(PlannerSettings, HaveAParameterForEveryFieldOfARequest) {
  const std::vector<wend::OptionInfo> parameters = request_parameters();
  std::set<std::string_view> without;
  for (const wend::RequestField& field : wend::request_fields()) {
    const bool there = std::ranges::any_of(parameters, [&](const wend::OptionInfo& parameter) {
      return field.info.is_called(parameter.name);
    });
    if (!there) without.insert(field.info.name);
  }
  EXPECT_EQ(without, (std::set<std::string_view>{"expansions", "from_field", "straighten"}));
}

std::string page(const std::string& name) {
  std::ifstream file(wend::test::source_folder() / "docs" / name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(PlannerSettings, AreOnThePagesWithTheirDefaults) {
  const std::string ros2 = page("ros2.md");
  for (const wend::OptionInfo& parameter : planner_schema("").plugin) {
    const std::string row = "| `" + parameter.name + "` | ";
    const bool word = parameter.kind == wend::OptionKind::choice;
    const std::string quote = word ? "`" : "";
    EXPECT_NE(ros2.find(row + quote + parameter.default_value + quote + " | "), std::string::npos)
        << row << parameter.default_value;
  }
  const std::string ros = page("ros.md");
  std::set<std::string_view> without;
  const auto look_for = [&](const wend::FieldInfo& field) {
    const bool there = ros.find("`" + std::string(field.name) + "`") != std::string::npos;
    if (!there) without.insert(field.name);
  };
  for (const wend::RequestField& field : wend::request_fields()) look_for(field.info);
  for (const wend::RobotField& field : wend::robot_fields()) look_for(field.info);
  // Messages have these, and `unknown_free` is `unknown`.
  EXPECT_EQ(without, (std::set<std::string_view>{"expansions", "explain", "spacing", "straighten",
                                                 "unknown"}));
}

TEST(PlannerSettings, PutTheirValuesIntoTheRequest) {
  const auto settings = settings_from("astar", {{"tolerance", "0.3"},
                                                {"heading_tolerance", "0.2"},
                                                {"nearest", "true"},
                                                {"escape", "0"},
                                                {"keep", "0.1"},
                                                {"explain", "false"}});
  ASSERT_TRUE(settings) << settings.error().message;
  wend::PlanRequest request{{}, {{{1, 2}}}};
  settings->request.put(request, 0.05);
  EXPECT_EQ(request.goals.front().tolerance, 0.3);
  EXPECT_EQ(request.goals.front().heading_tolerance, 0.2);
  EXPECT_TRUE(request.nearest);
  EXPECT_EQ(request.nearest_limit, 0.5);
  EXPECT_EQ(request.escape, 0);
  EXPECT_EQ(request.keep, 0.1);
  EXPECT_FALSE(request.explain);
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
