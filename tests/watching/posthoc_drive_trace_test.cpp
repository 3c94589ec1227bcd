// Posthoc traces of hybrid_astar: the events have ways.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/testing/drawn_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/posthoc_test_support.hpp"
#include "wend/report/posthoc_trace.hpp"

namespace wend {
namespace {

using test::events_of;
using test::json;
using test::kNoLimit;
using test::parsed;

/// A wall that the robot drives around.
std::string drawing() {
  std::string text;
  for (int y = 0; y < 24; ++y) {
    text += (y > 8 && y < 24 ? "...............##......................." : std::string(40, '.')) +
            '\n';
  }
  return text;
}

std::string driven_trace(const FreeSpace& space, TraceForm form) {
  const auto planner = make_planner("hybrid_astar", space, {{"turning_radius", "4"}}).value();
  const Query query{{5.5, 18.5, 0}, {Pose{30.5, 18.5, 0}}};
  PosthocTrace trace(space, query, cells_of(space), form, kNoLimit);
  Query observed = query;
  observed.observer = &trace;
  Plan plan;
  planner->plan(observed, plan);
  EXPECT_FALSE(plan.path.empty());
  return trace.finish(plan.path);
}

bool is_in_cell(const json& point, const json& event) {
  // The text has three decimals, so a pose may be rounded to the edge of its cell.
  constexpr double kRounding = 6e-4;
  const double x = point.at("x").get<double>() - event.at("x").get<double>();
  const double y = point.at("y").get<double>() - event.at("y").get<double>();
  return x > -kRounding && x < 1 + kRounding && y > -kRounding && y < 1 + kRounding;
}

TEST(PosthocTraceOfDrives, SaysWhatIsDrivenFromEachParent) {
  const FreeSpace space = test::drawn_space(drawing());
  const json trace = parsed(driven_trace(space, TraceForm::json), TraceForm::json);
  EXPECT_EQ(trace, parsed(driven_trace(space, TraceForm::yaml), TraceForm::yaml));
  std::map<json, json> latest;  // events by id
  std::size_t ways = 0;
  for (const json& event : events_of(trace, {"generating", "expanding"})) {
    latest[event.at("id")] = event;
    ASSERT_EQ(event.contains("way"), !event.at("pId").is_null()) << event;
    if (!event.contains("way")) continue;
    ++ways;
    const json& way = event.at("way");
    ASSERT_GE(way.size(), 2U) << event;
    EXPECT_TRUE(is_in_cell(way.back(), event)) << event;
    EXPECT_TRUE(is_in_cell(way.front(), latest.at(event.at("pId")))) << event;
  }
  EXPECT_GT(ways, 10U);
}

}  // namespace
}  // namespace wend
