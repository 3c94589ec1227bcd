#include "wend/planner/planner_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;

template <class Options>
class PlannerOptionsOf : public ::testing::Test {};

using AllOptions =
    ::testing::Types<AStarOptions, GreedyOptions, DijkstraOptions, BfsOptions, DfsOptions,
                     RandomWalkOptions, ShortestAnyAngleOptions, ThetaStarOptions,
                     LazyThetaStarOptions, CarOptions, LatticeOptions, ReplannerOptions,
                     DStarLiteOptions, AltOptions, HybridAStarOptions, AraStarOptions>;
TYPED_TEST_SUITE(PlannerOptionsOf, AllOptions);

template <class... Options>
std::vector<std::string> names_of(::testing::Types<Options...>) {
  return {std::string(Options::kPlanner)...};
}

TEST(PlannerOptions, AreThereForEveryPlannerWithOptions) {
  const std::vector<std::string> names = names_of(AllOptions{});
  for (const PlannerInfo& info : planners()) {
    if (info.options.empty()) continue;
    EXPECT_THAT(names, Contains(info.name));
  }
}

/// Sets every field to a random value of its range.
class Scrambler {
 public:
  explicit Scrambler(std::uint64_t seed) : random_(seed) {}

  void operator()(const OptionText& /*text*/, bool& value) { value = random_.chance(0.5); }
  void operator()(const OptionText& /*text*/, std::int64_t& value, OptionRange range) {
    value = static_cast<std::int64_t>(number_in(range));
  }
  void operator()(const OptionText& /*text*/, double& value, OptionRange range) {
    value = number_in(range);
  }
  template <class Enum>
    requires std::is_enum_v<Enum>
  void operator()(const OptionText& /*text*/, Enum& value) {
    const auto choices = choice_names(Enum{});
    value = choices[random_.below(choices.size())].value;
  }

 private:
  double number_in(OptionRange range) {
    const double most = random_.chance(0.9) ? std::min(range.greatest, 10.0) : range.greatest;
    return range.least + (most - range.least) * random_.uniform();
  }

  Random random_;
};

TYPED_TEST(PlannerOptionsOf, HaveTheFieldsOfTheRegistry) {
  const PlannerInfo* info = planners().find(TypeParam::kPlanner);
  ASSERT_NE(info, nullptr);
  const std::vector<OptionInfo> schema = option_schema<TypeParam>();
  ASSERT_EQ(schema.size(), info->options.size());
  for (std::size_t i = 0; i < schema.size(); ++i) {
    EXPECT_EQ(schema[i].name, info->options[i].name);
    EXPECT_EQ(schema[i].default_value, info->options[i].default_value);
    EXPECT_EQ(schema[i].choices, info->options[i].choices);
    EXPECT_EQ(schema[i].greatest, info->options[i].greatest);
  }
  EXPECT_THAT(option_values(TypeParam{}), IsEmpty());
}

TYPED_TEST(PlannerOptionsOf, AreTheSameAsText) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    TypeParam options;
    Scrambler scrambler(seed);
    TypeParam::fields(options, scrambler);
    const OptionValues values = option_values(options);
    const auto parsed = parse_options<TypeParam>(values);
    ASSERT_TRUE(parsed) << parsed.error().message;
    OptionWriter expected;
    OptionWriter written;
    TypeParam::fields(options, expected);
    TypeParam::fields(*parsed, written);
    EXPECT_EQ(written.values(), expected.values());
  }
}

TYPED_TEST(PlannerOptionsOf, MakeThePlannerThatTextMakes) {
  const FreeSpace space = test::drawn_space(R"(
..........
.####.....
..........
....###...
..........
)");
  int made = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    TypeParam options;
    Scrambler scrambler(seed);
    if (seed > 1) TypeParam::fields(options, scrambler);
    const PlannerSpec spec = planner_spec(options);
    EXPECT_EQ(spec.name, TypeParam::kPlanner);
    const auto typed = make_planner(space, options);
    const auto as_text = make_planner(spec.name, space, spec.options);
    ASSERT_EQ(typed.has_value(), as_text.has_value());
    if (!typed) {
      EXPECT_EQ(typed.error().message, as_text.error().message);
      continue;
    }
    ++made;
    Query query = Query::between({0, 0}, {9, 4});
    query.limits.expansions = 20'000;  // for a random walk
    Plan plan;
    Plan other;
    EXPECT_EQ((*typed)->plan(query, plan), (*as_text)->plan(query, other));
    EXPECT_EQ(plan.path, other.path);
    EXPECT_EQ(plan.metrics, other.metrics);
    EXPECT_EQ(plan.bound, other.bound);
  }
  EXPECT_GT(made, 0);
}

TEST(PlannerOptions, OutOfRangeAreRefused) {
  const FreeSpace space = test::open_space(3, 3);
  for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const auto planner = make_planner(space, AStarOptions{.weight = wrong});
    ASSERT_FALSE(planner) << wrong;
    EXPECT_EQ(planner.error().status, Status::invalid_option);
    EXPECT_EQ(planner.error().where, "weight");
  }
  const auto no_value = static_cast<Connectivity>(7);
  EXPECT_FALSE(make_planner(space, BfsOptions{.moves = {.connectivity = no_value}}));
  EXPECT_EQ(
      make_planner(space, CarOptions{.driving = {.unit = 2}, .turning_radius = 2}).error().status,
      Status::invalid_option);
}

}  // namespace
}  // namespace wend
