// Posthoc traces of car searches.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <vector>

#include "bench/comparison/random_queries.hpp"
#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/posthoc_test_support.hpp"
#include "wend/report/posthoc_trace.hpp"
#include "wend/robot/car_primitives.hpp"

namespace wend {
namespace {

using test::check_trace;
using test::events_of;
using test::json;
using test::kNoLimit;
using test::parsed;
using test::require;
using test::Seen;
using test::tail;
using test::Witness;

SearchEvent traced_drive(CornerPose to, std::optional<CornerPose> from, double g) {
  SearchEvent event{.cell = to.vertex,
                    .parent = std::nullopt,
                    .g = g,
                    .h = 0,
                    .f = g,
                    .heading = radians_of(to.heading)};
  if (from) {
    event.parent = from->vertex;
    event.parent_heading = radians_of(from->heading);
  }
  return event;
}

/// A drive of two moves, and a turn that led nowhere.
std::string trace_of_a_drive(const FreeSpace& space, TraceForm form, int unit = 1) {
  const CornerPose start{{0, 0}, Heading::plus_y};
  const CornerPose ahead = moved(start, CarMove::fwd, unit);
  const CornerPose goal = moved(ahead, CarMove::fwd_minus, unit);
  const Query query{pose_of(start), {pose_of(goal)}};
  PosthocTrace trace(space, query, corners_of(space, unit), form, kNoLimit);
  trace.on_generate(traced_drive(start, {}, 0));
  trace.on_expand(traced_drive(start, {}, 0));
  trace.on_generate(traced_drive(ahead, start, 1));
  trace.on_expand(traced_drive(ahead, start, 1));
  trace.on_generate(traced_drive(goal, ahead, 2.5));
  trace.on_expand(traced_drive(goal, ahead, 2.5));
  Path path;
  for (const CornerPose& place : {start, ahead, goal}) path.drive_to(pose_of(place));
  return trace.finish(path);
}

TEST(PosthocTraceOfACar, IsYaml) {
  const FreeSpace space = test::drawn_space("...\n..#\n");
  EXPECT_EQ(tail(trace_of_a_drive(space, TraceForm::yaml)), R"(events:
  - { type: map, id: "map", blocked: [[2,1,1,1]] }
  - { type: source, id: 3, x: 0, y: 0, heading: "S" }
  - { type: destination, id: 38, x: 1, y: 2, heading: "E" }
  - { type: generating, id: 3, x: 0, y: 0, heading: "S", pId: null, f: 0, g: 0, h: 0 }
  - { type: expanding, id: 3, x: 0, y: 0, heading: "S", pId: null, f: 0, g: 0, h: 0 }
  - { type: generating, id: 19, x: 0, y: 1, heading: "S", pId: 3, f: 1, g: 1, h: 0 }
  - { type: closing, id: 3, x: 0, y: 0, heading: "S" }
  - { type: expanding, id: 19, x: 0, y: 1, heading: "S", pId: 3, f: 1, g: 1, h: 0 }
  - { type: generating, id: 38, x: 1, y: 2, heading: "E", pId: 19, f: 2.5, g: 2.5, h: 0 }
  - { type: closing, id: 19, x: 0, y: 1, heading: "S" }
  - { type: expanding, id: 38, x: 1, y: 2, heading: "E", pId: 19, f: 2.5, g: 2.5, h: 0 }
  - { type: closing, id: 38, x: 1, y: 2, heading: "E" }
  - { type: end, id: 38, x: 1, y: 2, heading: "E", pId: 19 }
)");
}

/// The pose of a car's event.
CornerPose place_in(const json& event, const FreeSpace& space) {
  const int y = event.at("y").get<int>();
  return {{event.at("x").get<int>(), space.map().frame().y_up ? space.height() - y : y},
          parse_heading(event.at("heading").get<std::string>(), space.map().frame()).value()};
}

void check_drive(const std::vector<Seen>& seen, const json& trace, const FreeSpace& space) {
  std::map<json, CornerPose> places;
  const auto events = events_of(trace, {"generating", "expanding", "updating", "closing"});
  require(events.size() == seen.size(), "all events", events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto& [type, event] = seen[i];
    const CornerPose place{event.cell, nearest_heading(event.heading.value())};
    require(events[i].at("type") == type, type, events[i]);
    require(place_in(events[i], space) == place, "corner and heading", events[i]);
    const CornerPose known = places.emplace(events[i].at("id"), place).first->second;
    require(known == place, "one id for each corner and heading", events[i]);
    if (type == "closing") continue;
    const json& parent = events[i].at("pId");
    require(parent.is_null() == !event.parent, "has a parent", events[i]);
    if (!event.parent) continue;
    const CornerPose from{*event.parent, nearest_heading(event.parent_heading.value())};
    require(places.at(parent) == from, "parent", events[i]);
    require(events[i].at("g") == event.g, "g", events[i]);
  }
}

/// The poses from the start to the end, by the parents that the trace tells of.
Path drive_in(const json& trace, const FreeSpace& space) {
  std::map<json, json> latest;  // by id
  for (const json& event : events_of(trace, {"generating", "updating", "end"})) {
    latest[event.at("id")] = event;
  }
  Path path;
  for (json id = trace.at("events").back().at("id"); !id.is_null(); id = latest.at(id).at("pId")) {
    require(path.size() <= latest.size(), "no circle", id);
    path.drive_to(pose_of(place_in(latest.at(id), space)));
  }
  path.reverse();
  return path;
}

RC_GTEST_PROP(PosthocTraceOfACar, TellsEverySearchAsItWas, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const FreeSpace space = *make_free_space(test::random_map(random));
  const int unit = random.between(1, 2);
  const auto planner = make_planner("car", space, {{"lattice_resolution", std::to_string(unit)}});
  if (!planner) RC_DISCARD("no room");
  const auto drives = random_drives(space, corners_of(space, unit), 1, seed);
  if (drives.empty()) RC_DISCARD("no corners");
  RC_LOG() << "seed " << seed << ", unit " << unit << '\n' << test::drawing_of(space.map());
  Query query = drives.front();
  Witness witness;
  query.observer = &witness;
  Plan plan;
  (*planner)->plan(query, plan);
  witness.close_last();
  PosthocTrace trace(space, query, corners_of(space, unit), TraceForm::json, kNoLimit);
  query.observer = &trace;
  (*planner)->plan(query, plan);
  const json told = json::parse(trace.finish(plan.path));
  check_trace(told);
  check_drive(witness.seen(), told, space);
  const auto sources = events_of(told, {"source"});
  RC_ASSERT(sources.size() == 1U);
  RC_ASSERT(pose_of(place_in(sources.front(), space)) == query.start);
  RC_ASSERT(events_of(told, {"end"}).size() == (plan.path.empty() ? 0U : 1U));
  if (!plan.path.empty()) RC_ASSERT(drive_in(told, space) == plan.path);
}

TEST(PosthocTraceOfACar, IsATraceInBothForms) {
  const FreeSpace space = test::drawn_space("....\n....\n....\n....\n");
  for (const int unit : {1, 2}) {
    const json trace = json::parse(trace_of_a_drive(space, TraceForm::json, unit));
    EXPECT_EQ(trace, parsed(trace_of_a_drive(space, TraceForm::yaml, unit), TraceForm::yaml));
    EXPECT_NO_THROW(check_trace(trace));
    const json& dot = trace.at("views").at("main").at(1);
    EXPECT_EQ(dot.at("$"), "circle");
    EXPECT_EQ(dot.at("radius"), 0.14 * unit);
    EXPECT_EQ(dot.at("x"), "${{ $.x + " + format_number(0.22 * unit) +
                               " * (($.heading == 'E') - ($.heading == 'W')) }}");
    EXPECT_EQ(trace.at("pivot").at("y"), "${{ $.y }}");
  }
}

TEST(PosthocTraceOfACar, CountsCornersFromTheTopWhereYIsUp) {
  const FreeSpace space = *make_free_space(test::drawn_map("...\n...\n", {.y_up = true}));
  const Query query{{3, 2, 0}, {Goal(Point{0.4, -0.3})}};
  PosthocTrace trace(space, query, corners_of(space), TraceForm::json, kNoLimit);
  const json events = json::parse(trace.finish({})).at("events");
  EXPECT_EQ(events.at(0), json::parse(R"({"type":"source","id":46,"x":3,"y":0,"heading":"E"})"));
  ASSERT_EQ(events.size(), 5U) << "a goal with any heading is four";
  EXPECT_EQ(events.at(1),
            json::parse(R"({"type":"destination","id":0,"x":0,"y":2,"heading":"S"})"));
  EXPECT_EQ(events.at(4).at("heading"), "N");
}

TEST(PosthocTraceOfACar, LeavesOutWhatIsNotOnTheMap) {
  const FreeSpace space = test::open_space(2, 2);
  const Query query{{3, 0, 0}, {Goal(Point{1e30, 0}), Pose{0, -1, 0}}};
  PosthocTrace trace(space, query, corners_of(space), TraceForm::json, kNoLimit);
  EXPECT_EQ(json::parse(trace.finish({})).at("events"), json::array());
}

}  // namespace
}  // namespace wend
