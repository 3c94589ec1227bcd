#include "wend/session/request_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace wend {
namespace {

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
    names.emplace(field.info.name);
    ++count;
    if (!field.info.alias.empty()) {
      names.emplace(field.info.alias);
      ++count;
      EXPECT_EQ(request_field(field.info.alias), &field);
    }
    EXPECT_FALSE(field.info.help.empty()) << field.info.name;
    EXPECT_FALSE(field.info.help.ends_with('.')) << field.info.name;
    EXPECT_EQ(request_field(field.info.name), &field);
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
  EXPECT_EQ(request_field("neerest"), nullptr);
  EXPECT_EQ(request_field("escape")->info.default_value, unset.escape);
  EXPECT_EQ(request_field("keep")->info.default_value, unset.keep);
  EXPECT_EQ(request_field("time_limit")->info.default_value, unset.limits.seconds);
  EXPECT_EQ(request_field("nearest")->info.default_value != 0, unset.nearest);
  EXPECT_EQ(request_field("closest")->info.default_value != 0, unset.closest);
  EXPECT_EQ(request_field("explain")->info.default_value != 0, unset.explain);
  EXPECT_EQ(request_field("from_field")->info.default_value != 0, unset.from_field);
  EXPECT_EQ(request_field("explain")->info.option().default_value, "true");
  EXPECT_EQ(request_field("nearest_limit")->info.option().default_value, "");
  for (const RequestField& field : request_fields()) {
    const FieldInfo& info = field.info;
    if (std::isnan(info.default_value)) continue;
    EXPECT_FALSE(info.fault_of(info.default_value)) << info.name;
    if (std::isinf(info.default_value)) continue;
    EXPECT_EQ(info.number_of(info.option().default_value), info.default_value) << info.name;
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
    return request_field(name)->info.fault_of(value)->message;
  };
  EXPECT_EQ(fault("nearest", 2), "option 'nearest': '2' is neither 0 nor 1");
  EXPECT_EQ(fault("keep", -1), "option 'keep': '-1' is less than 0");
  EXPECT_EQ(fault("escape", 2e9), "option 'escape': '2e+09' is not between 0 and 1e+09");
  EXPECT_EQ(fault("expansions", 1.5), "option 'expansions': '1.5' is not a whole number");
  EXPECT_EQ(request_field("tolerance")->info.fault_of(-1, "tolerance")->message,
            "option 'tolerance': '-1' is not between 0 and 1e+09");
  EXPECT_EQ(request_field("nearest")->info.number_of("yes").error().message,
            "option 'nearest': 'yes' is neither true nor false");
}

}  // namespace
}  // namespace wend
