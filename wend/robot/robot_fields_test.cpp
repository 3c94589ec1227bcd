#include "wend/robot/robot_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace wend {
namespace {

FreeSpaceOptions robot_with(std::string_view name, double value) {
  FreeSpaceOptions robot;
  const auto set = robot_field(name)->set(robot, value);
  EXPECT_TRUE(set) << name << ": " << set.error().message;
  return robot;
}

TEST(RobotFields, HaveNamesOfTheirOwnAndAreDescribed) {
  std::set<std::string> names;
  for (const RobotField& field : robot_fields()) {
    EXPECT_TRUE(names.emplace(field.info.name).second) << field.info.name;
    EXPECT_FALSE(field.info.help.empty()) << field.info.name;
    EXPECT_FALSE(field.info.help.ends_with('.')) << field.info.name;
    EXPECT_EQ(robot_field(field.info.name), &field);
  }
  EXPECT_EQ(robot_field("radius"), robot_field("robot_radius"));
  EXPECT_EQ(robot_field("keep_away"), robot_field("clearance_distance"));
  EXPECT_EQ(robot_field("clearance"), nullptr);
}

TEST(RobotFields, TheirDefaultsAreThoseOfARobot) {
  FreeSpaceOptions robot{.footprint = Footprint::disc(1),
                         .unknown = UnknownPolicy::free,
                         .outside = OutsidePolicy::free,
                         .clearance_distance = 1,
                         .clearance_cost = 1};
  for (const RobotField& field : robot_fields()) {
    ASSERT_TRUE(field.set(robot, field.info.default_value)) << field.info.name;
    const std::string text = field.info.option().default_value;
    if (text.empty()) continue;
    EXPECT_EQ(field.info.number_of(text), field.info.default_value);
  }
  EXPECT_EQ(robot, FreeSpaceOptions{});
}

TEST(RobotFields, SetWhatTheyName) {
  EXPECT_EQ(robot_with("robot_radius", 0.2).footprint, Footprint::disc(0.2));
  EXPECT_EQ(robot_with("clearance_distance", 0.5).clearance_distance, 0.5);
  EXPECT_EQ(robot_with("clearance_cost", 2).clearance_cost, 2);
  for (const auto& [text, unknown, outside] :
       {std::tuple("blocked", UnknownPolicy::blocked, OutsidePolicy::blocked),
        std::tuple("free", UnknownPolicy::free, OutsidePolicy::free)}) {
    EXPECT_EQ(robot_with("unknown", *robot_field("unknown")->info.number_of(text)).unknown,
              unknown);
    EXPECT_EQ(robot_with("outside", *robot_field("outside")->info.number_of(text)).outside,
              outside);
  }
}

TEST(RobotFields, RefuseWhatIsNotInTheirRange) {
  FreeSpaceOptions robot;
  for (const RobotField& field : robot_fields()) {
    for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
      const auto set = field.set(robot, wrong);
      ASSERT_FALSE(set) << field.info.name;
      EXPECT_EQ(set.error().status, Status::invalid_option);
      EXPECT_EQ(set.error().where, field.info.name);
    }
  }
  EXPECT_EQ(robot, FreeSpaceOptions{});
  EXPECT_EQ(robot_field("unknown")->info.fault_of(3)->message,
            "option 'unknown': '3' is not one of blocked, free");
  EXPECT_EQ(robot_field("unknown")->info.number_of("maybe").error().message,
            "option 'unknown': 'maybe' is not one of blocked, free");
  EXPECT_TRUE(robot_field("outside")->info.fault_of(1.5));
}

}  // namespace
}  // namespace wend
