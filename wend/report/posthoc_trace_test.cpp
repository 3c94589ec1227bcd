// Compares traces with the rules of the format and with an independent record of a replayed search.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "conformance/trial.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/posthoc_test_support.hpp"
#include "wend/report/posthoc_trace.hpp"

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

Cell cell_in(const json& event, const FreeSpace& space) {
  const int y = event.at("y").get<int>();
  return {event.at("x").get<int>(), space.map().frame().y_up ? space.height() - 1 - y : y};
}

struct Search {
  const FreeSpace& space;
  std::string planner;
  OptionValues options;
  test::TestQuery test_query;

  Plan run(SearchObserver& observer) const {
    Query query = test_query.query();
    query.limits.expansions = 500;
    query.observer = &observer;
    Plan plan;
    make_planner(planner, space, options).value()->plan(query, plan);
    return plan;
  }
};

/// Checks that the trace begins with the events that a witness saw, as far as it goes.
void check_against(const std::vector<Seen>& seen, const json& trace, const FreeSpace& space) {
  std::map<json, Cell> cells;
  const auto events = events_of(trace, {"generating", "expanding", "updating", "closing"});
  require(events.size() <= seen.size(), "no more events than there were", events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto& [type, event] = seen[i];
    require(events[i].at("type") == type, type, events[i]);
    require(cell_in(events[i], space) == event.cell, "cell", events[i]);
    cells[events[i].at("id")] = event.cell;
    if (type == "closing") continue;
    const json& parent = events[i].at("pId");
    require(parent.is_null() == !event.parent, "has a parent", events[i]);
    require(!event.parent || cells.at(parent) == *event.parent, "parent", events[i]);
    require(events[i].at("f") == event.f, "f", events[i]);
    require(events[i].at("g") == event.g, "g", events[i]);
    require(events[i].at("h") == event.h, "h", events[i]);
  }
}

/// The cells from the end back to where there is no parent, the last one first.
std::vector<Cell> way_back(const json& trace, const FreeSpace& space) {
  std::map<json, json> latest;  // by id
  for (const json& event : events_of(trace, {"generating", "expanding", "updating", "end"})) {
    latest[event.at("id")] = event;
  }
  std::vector<Cell> way;
  json id = trace.at("events").back().at("id");
  while (!id.is_null()) {
    require(way.size() <= latest.size(), "no circle", id);
    way.push_back(cell_in(latest.at(id), space));
    id = latest.at(id).at("pId");
  }
  return way;
}

void check_end(const Path& path, const json& trace, const FreeSpace& space) {
  const auto ends = events_of(trace, {"end"});
  require(ends.size() == (path.empty() ? 0U : 1U), "an end where there is a path", ends);
  if (path.empty()) return;
  std::vector<Cell> way = way_back(trace, space);
  std::reverse(way.begin(), way.end());
  require(Path(way) == path, "the way back is the path", ends);
  const auto sources = events_of(trace, {"source"});
  require(cell_in(sources.front(), space) == path.cells().front(), "source", sources);
}

void check_map(const json& trace, const FreeSpace& space) {
  Grid<int> covered(space.width(), space.height(), 0);
  for (const json& event : events_of(trace, {"map"})) {
    for (const json& rectangle : event.at("blocked")) {
      const auto [x, y, width, height] = rectangle.get<std::array<int, 4>>();
      for (int row = y; row < y + height; ++row) {
        for (int column = x; column < x + width; ++column) {
          const Cell cell = cell_in({{"x", column}, {"y", row}}, space);
          require(space.contains(cell), "inside the map", rectangle);
          ++covered[cell];
        }
      }
    }
  }
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      require(covered[{x, y}] == (space.passable({x, y}) ? 0 : 1), "blocked", json{x, y});
    }
  }
}

/// The planners that search from cell to neighbouring cell: their parents are the path.
std::vector<std::string> walking_planners() {
  std::vector<std::string> names = planner_names("cells");
  // One that resumes begins at the goal, or where it stopped; an anytime planner expands states again.
  std::erase_if(names, [](const std::string& name) {
    const Capabilities& can = planners().find(name)->capabilities;
    return can.jumps || can.resumes || can.anytime;
  });
  return names;
}

RC_GTEST_PROP(PosthocTrace, TellsEverySearchAsItWas, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const auto names = walking_planners();
  const PlannerInfo& info = *planners().find(names[random.below(names.size())]);
  const test::Trial trial = test::random_trial(seed, info);
  const FreeSpace space = *make_free_space(trial.map, trial.robot);
  if (!info.capabilities.terrain && !space.uniform_terrain()) RC_DISCARD("terrain");
  const Search search{space, info.name, trial.options, test::random_test_query(random, trial.map)};
  RC_LOG() << info.name << ", " << test::text_of(trial, seed) << test::text_of(search.test_query);
  const std::uint64_t most = random.chance(0.5) ? kNoLimit : random.below(60);

  Witness witness;
  const Plan plan = search.run(witness);
  witness.close_last();
  std::map<TraceForm, json> traces;
  for (const TraceForm form : {TraceForm::yaml, TraceForm::json}) {
    PosthocTrace trace(space, search.test_query.start, search.test_query.ends(space.map()), form,
                       most);
    RC_ASSERT(search.run(trace).path == plan.path);
    const std::string text = trace.finish(plan.path);
    traces[form] = parsed(text, form);
    const std::uint64_t count = witness.seen().size();
    RC_ASSERT(trace.dropped() == count - std::min(count, most));
  }
  const json& trace = traces[TraceForm::json];
  RC_ASSERT(trace == traces[TraceForm::yaml]);
  check_trace(trace);
  check_map(trace, space);
  check_against(witness.seen(), trace, space);
  if (most == kNoLimit) check_end(plan.path, trace, space);
}

TEST(PosthocTrace, FollowsAWalkThatComesBack) {
  const FreeSpace space = test::open_space(6, 2);
  for (int seed = 1; seed <= 20; ++seed) {
    const test::TestQuery test_query{{0, 0}, {Cell{5, 1}}};
    PosthocTrace trace(space, test_query.start, test_query.ends(space.map()), TraceForm::json,
                       kNoLimit);
    const Plan plan =
        Search{space, "random_walk", {{"seed", std::to_string(seed)}}, test_query}.run(trace);
    const json told = json::parse(trace.finish(plan.path));
    EXPECT_NO_THROW(check_trace(told)) << seed;
    EXPECT_NO_THROW(check_end(plan.path, told, space)) << seed;
  }
}

std::string trace_of(const FreeSpace& space, TraceForm form, std::uint64_t most) {
  const test::TestQuery test_query{{0, 0}, {Cell{2, 0}}};
  PosthocTrace trace(space, test_query.start, test_query.ends(space.map()), form, most);
  const Plan plan = Search{space, "astar", {{"connectivity", "4"}}, test_query}.run(trace);
  return trace.finish(plan.path);
}

TEST(PosthocTrace, IsYaml) {
  const FreeSpace space = test::drawn_space("...\n##.\n");
  EXPECT_EQ(tail(trace_of(space, TraceForm::yaml, kNoLimit)), R"(events:
  - { type: map, id: "map", blocked: [[0,1,2,1]] }
  - { type: source, id: 0, x: 0, y: 0 }
  - { type: destination, id: 2, x: 2, y: 0 }
  - { type: generating, id: 0, x: 0, y: 0, pId: null, f: 2, g: 0, h: 2 }
  - { type: expanding, id: 0, x: 0, y: 0, pId: null, f: 2, g: 0, h: 2 }
  - { type: generating, id: 1, x: 1, y: 0, pId: 0, f: 2, g: 1, h: 1 }
  - { type: closing, id: 0, x: 0, y: 0 }
  - { type: expanding, id: 1, x: 1, y: 0, pId: 0, f: 2, g: 1, h: 1 }
  - { type: generating, id: 2, x: 2, y: 0, pId: 1, f: 2, g: 2, h: 0 }
  - { type: closing, id: 1, x: 1, y: 0 }
  - { type: expanding, id: 2, x: 2, y: 0, pId: 1, f: 2, g: 2, h: 0 }
  - { type: closing, id: 2, x: 2, y: 0 }
  - { type: end, id: 2, x: 2, y: 0, pId: 1 }
)");
}

TEST(PosthocTrace, EndsWithoutAParentWhereTheLimitCameBeforeIt) {
  const FreeSpace space = test::open_space(3, 1);
  EXPECT_EQ(tail(trace_of(space, TraceForm::yaml, 2)), R"(events:
  - { type: source, id: 0, x: 0, y: 0 }
  - { type: destination, id: 2, x: 2, y: 0 }
  - { type: generating, id: 0, x: 0, y: 0, pId: null, f: 2, g: 0, h: 2 }
  - { type: expanding, id: 0, x: 0, y: 0, pId: null, f: 2, g: 0, h: 2 }
  - { type: end, id: 2, x: 2, y: 0, pId: null }
)");
}

TEST(PosthocTrace, CountsRowsFromTheTopWhereYIsUp) {
  const FreeSpace space = *make_free_space(test::drawn_map("...\n##.\n", {.y_up = true}));
  const json trace = parsed(trace_of(space, TraceForm::json, kNoLimit), TraceForm::json);
  EXPECT_EQ(trace.at("events").at(0).at("blocked"), json::parse("[[0,0,2,1]]"));
  EXPECT_EQ(trace.at("events").at(1), json::parse(R"({"type":"source","id":0,"x":0,"y":1})"));
}

TEST(PosthocTrace, OfNothingIsATraceToo) {
  const FreeSpace space = test::open_space(2, 2);
  for (const TraceForm form : {TraceForm::yaml, TraceForm::json}) {
    PosthocTrace trace(space, {-1, 0}, std::vector<Cell>{{2, 0}}, form, kNoLimit);
    EXPECT_EQ(parsed(trace.finish({}), form).at("events"), json::array());
  }
}

TEST(PosthocTrace, LeavesOutAMapThatTakesTooManyRectangles) {
  Grid<CellState> chessboard(200, 200, CellState::free);
  for (int i = 0; i < 40'000; ++i) {
    const Cell cell{i % 200, i / 200};
    if ((cell.x + cell.y) % 2 == 1) chessboard[cell] = CellState::occupied;
  }
  PosthocTrace trace(*make_free_space(*make_grid_map(chessboard)), {0, 0}, std::vector<Cell>{},
                     TraceForm::json, kNoLimit);
  const json events = json::parse(trace.finish({})).at("events");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.at(0).at("type"), "source");
}

}  // namespace
}  // namespace wend
