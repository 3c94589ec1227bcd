#include "wend/session/request_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace wend {
namespace {

using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PlanRequest request_with(std::string_view name, double value, double resolution = 1) {
  PlanRequest request{{}, {{{1, 2}}, {{3, 4}}}};
  const auto set = request_field(name)->set(request, value, resolution);
  EXPECT_TRUE(set) << name << ": " << set.error().message;
  return request;
}

TEST(RequestFields, HaveNamesOfTheirOwnAndAreDescribed) {
  std::set<std::string> names;
  std::size_t count = 0;
  for (const RequestField& field : request_fields()) {
    names.insert(field.info.name);
    names.insert(field.info.aliases.begin(), field.info.aliases.end());
    count += 1 + field.info.aliases.size();
    EXPECT_FALSE(field.info.help.empty()) << field.info.name;
    EXPECT_FALSE(field.info.help.ends_with('.')) << field.info.name;
    EXPECT_EQ(request_field(field.info.name), &field);
    for (const std::string& alias : field.info.aliases) EXPECT_EQ(request_field(alias), &field);
  }
  EXPECT_EQ(names.size(), count);
  for (const PlannerInfo& planner : planners()) {
    for (const OptionInfo& option : planner.options) {
      EXPECT_FALSE(names.contains(option.name)) << planner.name << " has an option " << option.name;
    }
  }
}

TEST(RequestFields, KnowTheDefaultsOfARequest) {
  const PlanRequest unset;
  EXPECT_EQ(request_field("escape")->default_value, unset.escape);
  EXPECT_EQ(request_field("explain")->info.default_value, "true");
  EXPECT_EQ(request_field("nearest_limit")->info.default_value, "");
  for (const RequestField& field : request_fields()) {
    if (std::isnan(field.default_value)) continue;
    EXPECT_FALSE(field.fault_of(field.default_value)) << field.info.name;
    if (std::isinf(field.default_value)) continue;
    EXPECT_EQ(field.number_of(field.info.default_value), field.default_value) << field.info.name;
  }
}

TEST(RequestFields, SetWhatTheyName) {
  for (const MapGoal& goal : request_with("tolerance", 0.5).goals) EXPECT_EQ(goal.tolerance, 0.5);
  for (const MapGoal& goal : request_with("goal_heading_tolerance", 0.5).goals) {
    EXPECT_EQ(goal.heading_tolerance, 0.5);
    EXPECT_EQ(goal.tolerance, 0);
  }
  EXPECT_EQ(request_with("time_limit", 3).limits.seconds, 3);
  EXPECT_EQ(request_with("expansions", 0).limits.expansions, 0U);
  EXPECT_EQ(request_with("expansions", kInfinity).limits.expansions, Limits::kUnlimited);
  EXPECT_EQ(request_with("expansions", std::ldexp(1, 64)).limits.expansions, Limits::kUnlimited);
  EXPECT_TRUE(request_with("nearest", 1).nearest);
  EXPECT_EQ(request_with("nearest_limit", kInfinity).nearest_limit, kInfinity);
  EXPECT_EQ(request_with("escape", 2).escape, 2);
  EXPECT_TRUE(request_with("closest", 1).closest);
  EXPECT_EQ(request_with("keep", 2).keep, 2);
  EXPECT_FALSE(request_with("explain", 0).explain);
  EXPECT_TRUE(request_with("from_field", 1).from_field);
  EXPECT_TRUE(request_with("straighten", 1).refinement.simplify);
  EXPECT_EQ(request_with("spacing", 0.2, 0.05).refinement.spacing, 4);
  EXPECT_FALSE(request_with("spacing", 0).refinement.spacing);
}

TEST(RequestFields, RefuseWhatIsNotInTheirRange) {
  PlanRequest request;
  for (const RequestField& field : request_fields()) {
    for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN(), -kInfinity}) {
      const auto set = field.set(request, wrong, 1);
      ASSERT_FALSE(set) << field.info.name;
      EXPECT_EQ(set.error().status, Status::invalid_option);
      EXPECT_EQ(set.error().where, field.info.name);
    }
  }
  const auto fault = [&](std::string_view name, double value) {
    return request_field(name)->fault_of(value)->message;
  };
  EXPECT_EQ(fault("nearest", 2), "option 'nearest': '2' is neither 0 nor 1");
  EXPECT_EQ(fault("keep", -1), "option 'keep': '-1' is less than 0");
  EXPECT_EQ(fault("escape", 2e9), "option 'escape': '2e+09' is not between 0 and 1e+09");
  EXPECT_EQ(fault("expansions", 1.5), "option 'expansions': '1.5' is not a whole number");
  EXPECT_EQ(request_field("tolerance")->fault_of(-1, "tolerance")->message,
            "option 'tolerance': '-1' is not between 0 and 1e+09");
  EXPECT_EQ(request_field("nearest")->number_of("yes").error().message,
            "option 'nearest': 'yes' is neither true nor false");
}

TEST(RequestFields, SuggestANameForAnother) {
  EXPECT_EQ(request_field("neerest"), nullptr);
  const Error error = unknown_request_field("neerest");
  EXPECT_EQ(error.status, Status::invalid_option);
  EXPECT_THAT(error.message, HasSubstr("did you mean 'nearest'?"));
}

}  // namespace
}  // namespace wend
