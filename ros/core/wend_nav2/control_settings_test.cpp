// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/control_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "wend/control/controller.hpp"

namespace wend_nav2 {
namespace {

using testing::HasSubstr;

TEST(ControlSettings, EveryControllerHasAParameterOfEachNameOnce) {
  for (const std::string& name : wend::controllers().names()) {
    SCOPED_TRACE(name);
    const ControllerSchema schema = controller_schema(name);
    std::set<std::string> names{schema.name.name};
    wend::OptionValues values;
    for (const auto* options :
         {&schema.plugin, &schema.robot, &schema.follower, &schema.controller}) {
      for (const wend::OptionInfo& option : *options) {
        EXPECT_TRUE(names.insert(option.name).second) << option.name;
        EXPECT_FALSE(option.help.empty());
        values.emplace_back(option.name, option.default_value);
      }
    }
    EXPECT_FALSE(names.contains("goal_tolerance"));
    EXPECT_TRUE(names.contains("off_path"));
    EXPECT_TRUE(names.contains("turn_rate"));
    const auto settings = control_settings_from(name, values);
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_EQ(settings->controller, name);
  }
}

TEST(ControlSettings, ValuesGoWhereTheyBelong) {
  const auto settings = control_settings_from("pure_pursuit", {{"speed", "0.3"},
                                                               {"obstacles", "footprint"},
                                                               {"off_path", "2"},
                                                               {"lookahead", "0.7"},
                                                               {"allow_unknown", "false"}});
  ASSERT_TRUE(settings) << settings.error().message;
  EXPECT_EQ(settings->robot.limits.speed, 0.3);
  EXPECT_EQ(settings->plugin,
            (ControlOptions{.obstacles = ObstacleRule::footprint, .allow_unknown = false}));
  EXPECT_EQ(settings->follower.off_path, 2);
  EXPECT_TRUE(settings->follower.turns_in_place);
  EXPECT_EQ(settings->options, (wend::OptionValues{{"lookahead", "0.7"}}));
}

TEST(ControlSettings, FaultsAreSentences) {
  const auto fault_of = [](const std::string& controller, const wend::OptionValues& values) {
    const auto settings = control_settings_from(controller, values);
    EXPECT_FALSE(settings);
    return settings ? std::string() : settings.error().message;
  };
  EXPECT_THAT(fault_of("pursuit", {}), HasSubstr("pure_pursuit"));
  EXPECT_THAT(fault_of("p", {{"speed", "0"}}), HasSubstr("speed"));
  EXPECT_THAT(fault_of("p", {{"lookahead", "1"}}), HasSubstr("lookahead"));
  EXPECT_THAT(fault_of("stanley", {{"off_path", "wide"}}), HasSubstr("off_path"));
  EXPECT_THAT(fault_of("p", {{"drivetrain", "bicycle"}}), HasSubstr("turn"));
}

TEST(ControlSettings, NumbersThatAreNotFiniteAreRefused) {
  const ControllerSchema schema = controller_schema("pure_pursuit");
  for (const auto* options :
       {&schema.plugin, &schema.robot, &schema.follower, &schema.controller}) {
    for (const wend::OptionInfo& option : *options) {
      if (option.kind != wend::OptionKind::number) continue;
      for (const char* number : {"nan", "inf", "-inf", "1e300"}) {
        EXPECT_FALSE(control_settings_from("pure_pursuit", {{option.name, number}}))
            << option.name << ' ' << number;
      }
    }
  }
}

TEST(ControlSettings, ARobotThatSteersDoesNotTurnInPlace) {
  const auto settings = control_settings_from("pure_pursuit", {{"drivetrain", "bicycle"}});
  ASSERT_TRUE(settings) << settings.error().message;
  EXPECT_FALSE(settings->follower.turns_in_place);
}

}  // namespace
}  // namespace wend_nav2
