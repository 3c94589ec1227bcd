// Traces against the rules of the format and against a replay of the search that writes down what
// it sees for itself.

#include "wend/report/posthoc_trace.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/trial.hpp"
#include "wend/base/parse.hpp"
#include "wend/geometry/car_move.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using nlohmann::json;

constexpr std::uint64_t kNoLimit = 1'000'000'000;

/// YAML as the JSON of the same data.
json json_of(const YAML::Node& node) {
  json value;
  if (node.IsMap()) {
    for (const auto& entry : node) value[entry.first.Scalar()] = json_of(entry.second);
  } else if (node.IsSequence()) {
    value = json::array();
    for (const auto& entry : node) value.push_back(json_of(entry));
  } else if (node.IsScalar()) {
    const bool quoted = node.Tag() == "!";
    const auto number = quoted ? std::nullopt : parse_number(node.Scalar());
    value = number ? json(*number) : json(node.Scalar());
  }
  return value;
}

json parsed(const std::string& text, TraceForm form) {
  return form == TraceForm::json ? json::parse(text) : json_of(YAML::Load(text));
}

void require(bool holds, const std::string& rule, const json& of) {
  if (!holds) throw std::runtime_error(rule + ": " + of.dump());
}

void check_head(const json& trace) {
  require(trace.at("version") == "1.4.0", "version", trace.at("version"));
  const std::set<std::string> primitives{"rect", "circle", "polygon", "path"};
  require(!trace.at("views").at("main").empty(), "main shows something", trace.at("views"));
  for (const auto& [name, drawables] : trace.at("views").items()) {
    for (const json& drawable : drawables) {
      const auto kind = drawable.at("$").get<std::string>();
      require(primitives.count(kind) > 0 || trace.at("views").contains(kind), "drawable", drawable);
      std::vector<const char*> properties{"x", "y", "fill"};
      if (kind == "rect") properties.insert(properties.end(), {"width", "height"});
      if (kind == "circle") properties.push_back("radius");
      for (const char* property : properties) {
        require(drawable.contains(property), property, drawable);
      }
    }
  }
  require(trace.at("pivot").at("x").is_string() && trace.at("pivot").at("y").is_string(), "pivot",
          trace.at("pivot"));
}

/// Throws where a trace breaks a rule of the format or of the order of its events.
void check_trace(const json& trace) {
  check_head(trace);
  const std::set<std::string> types{"map",       "source",   "destination", "generating",
                                    "expanding", "updating", "closing",     "end"};
  std::map<std::string, std::set<json>> seen;  // ids by type of event
  std::set<json> ids;
  for (const json& event : trace.at("events")) {
    const json& id = event.at("id");
    const auto type = event.at("type").get<std::string>();
    require(id.is_number() || id.is_string(), "id", event);
    require(types.count(type) > 0, "type", event);
    if (event.contains("pId") && !event.at("pId").is_null()) {
      require(ids.count(event.at("pId")) > 0, "parent is known", event);
      require(event.at("pId") != id, "parent is another", event);
    }
    if (type == "expanding" || type == "updating") {
      require(seen["generating"].count(id) > 0, "generated before", event);
    }
    if (type == "updating") require(seen["closing"].count(id) == 0, "still open", event);
    if (type == "closing") require(seen["expanding"].count(id) > 0, "expanded before", event);
    require(seen["end"].empty(), "end comes last", event);
    const bool is_new = seen[type].insert(id).second;
    require(is_new || type == "updating" || type == "destination", "only once", event);
    ids.insert(id);
  }
}

std::vector<json> events_of(const json& trace, const std::set<std::string>& types) {
  std::vector<json> events;
  for (const json& event : trace.at("events")) {
    if (types.count(event.at("type").get<std::string>()) > 0) events.push_back(event);
  }
  return events;
}

Cell cell_in(const json& event, const FreeSpace& space) {
  const int y = event.at("y").get<int>();
  return {event.at("x").get<int>(), space.map().frame().y_up ? space.height() - 1 - y : y};
}

struct Seen {
  std::string type;
  SearchEvent event;
};

/// Writes down a search as a trace should tell it.
class Witness final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override { seen_.push_back({"generating", event}); }
  void on_relax(const SearchEvent& event) override { seen_.push_back({"updating", event}); }
  void on_expand(const SearchEvent& event) override {
    close_last();
    seen_.push_back({"expanding", event});
    last_ = event;
  }
  void close_last() {
    if (last_) seen_.push_back({"closing", *last_});
  }
  const std::vector<Seen>& seen() const { return seen_; }

 private:
  std::vector<Seen> seen_;
  std::optional<SearchEvent> last_;
};

struct Search {
  const FreeSpace& space;
  std::string planner;
  OptionValues options;
  test::Errand errand;

  Plan run(SearchObserver& observer) const {
    Query query = errand.query();
    query.limits.expansions = 500;
    query.observer = &observer;
    Plan plan;
    make_planner(planner, space, options).value()->plan(query, plan);
    return plan;
  }
};

/// Are these the events that a witness saw, as far as they go?
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

RC_GTEST_PROP(PosthocTrace, TellsEverySearchAsItWas, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const auto names = planner_names(Motion::cells);
  const PlannerInfo& info = *planners().find(names[random.below(names.size())]);
  const test::Trial trial = test::random_trial(seed, info);
  const FreeSpace space(trial.map, trial.robot);
  if (!info.plans_on_terrain && !space.uniform_terrain()) RC_DISCARD("terrain");
  const Search search{space, info.name, trial.options, test::random_errand(random, trial.map)};
  RC_LOG() << info.name << ", " << test::text_of(trial, seed) << test::text_of(search.errand);
  const std::uint64_t most = random.chance(0.5) ? kNoLimit : random.below(60);

  Witness witness;
  const Plan plan = search.run(witness);
  witness.close_last();
  std::map<TraceForm, json> traces;
  for (const TraceForm form : {TraceForm::yaml, TraceForm::json}) {
    PosthocTrace trace(space, search.errand.start, search.errand.goals, form, most);
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
    const test::Errand errand{{0, 0}, {{5, 1}}};
    PosthocTrace trace(space, errand.start, errand.goals, TraceForm::json, kNoLimit);
    const Plan plan =
        Search{space, "random_walk", {{"seed", std::to_string(seed)}}, errand}.run(trace);
    const json told = json::parse(trace.finish(plan.path));
    EXPECT_NO_THROW(check_trace(told)) << seed;
    EXPECT_NO_THROW(check_end(plan.path, told, space)) << seed;
  }
}

std::string trace_of(const FreeSpace& space, TraceForm form, std::uint64_t most) {
  const test::Errand errand{{0, 0}, {{2, 0}}};
  PosthocTrace trace(space, errand.start, errand.goals, form, most);
  const Plan plan = Search{space, "astar", {{"connectivity", "4"}}, errand}.run(trace);
  return trace.finish(plan.path);
}

std::string tail(const std::string& text) { return text.substr(text.find("\nevents:") + 1); }

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
  const FreeSpace space(test::drawn_map("...\n##.\n", {.y_up = true}));
  const json trace = parsed(trace_of(space, TraceForm::json, kNoLimit), TraceForm::json);
  EXPECT_EQ(trace.at("events").at(0).at("blocked"), json::parse("[[0,0,2,1]]"));
  EXPECT_EQ(trace.at("events").at(1), json::parse(R"({"type":"source","id":0,"x":0,"y":1})"));
}

SearchEvent driven(CornerPose to, std::optional<CornerPose> from, double g) {
  SearchEvent event{
      .cell = to.corner, .parent = std::nullopt, .g = g, .h = 0, .f = g, .heading = to.heading};
  if (from) {
    event.parent = from->corner;
    event.parent_heading = from->heading;
  }
  return event;
}

/// A drive of two moves, and a turn that led nowhere.
std::string trace_of_a_drive(const FreeSpace& space, TraceForm form, int unit = 1) {
  const bool y_up = space.map().frame().y_up;
  const CornerPose start{{0, 0}, Heading::south};
  const CornerPose ahead = moved(start, CarMove::fwd, y_up, unit);
  const CornerPose goal = moved(ahead, CarMove::fwd_left, y_up, unit);
  const Query query{pose_of(start, y_up), {pose_of(goal, y_up)}};
  PosthocTrace trace(space, query, unit, form, kNoLimit);
  trace.on_generate(driven(start, {}, 0));
  trace.on_expand(driven(start, {}, 0));
  trace.on_generate(driven(ahead, start, 1));
  trace.on_expand(driven(ahead, start, 1));
  trace.on_generate(driven(goal, ahead, 2.5));
  trace.on_expand(driven(goal, ahead, 2.5));
  Path path;
  for (const CornerPose& place : {start, ahead, goal}) path.drive_to(pose_of(place, y_up));
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
  const FreeSpace space(test::drawn_map("...\n...\n", {.y_up = true}));
  const Query query{{3, 2, 0}, {Goal(Point{0.4, -0.3})}};
  PosthocTrace trace(space, query, 1, TraceForm::json, kNoLimit);
  const json events = json::parse(trace.finish({})).at("events");
  EXPECT_EQ(events.at(0), json::parse(R"({"type":"source","id":46,"x":3,"y":0,"heading":"E"})"));
  ASSERT_EQ(events.size(), 5U) << "a goal with any heading is four";
  EXPECT_EQ(events.at(1),
            json::parse(R"({"type":"destination","id":0,"x":0,"y":2,"heading":"N"})"));
  EXPECT_EQ(events.at(4).at("heading"), "S");
}

TEST(PosthocTraceOfACar, LeavesOutWhatIsNotOnTheMap) {
  const FreeSpace space = test::open_space(2, 2);
  const Query query{{3, 0, 0}, {Goal(Point{1e30, 0}), Pose{0, -1, 0}}};
  PosthocTrace trace(space, query, 1, TraceForm::json, kNoLimit);
  EXPECT_EQ(json::parse(trace.finish({})).at("events"), json::array());
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
  PosthocTrace trace(FreeSpace(GridMap(chessboard)), {0, 0}, std::vector<Cell>{}, TraceForm::json,
                     kNoLimit);
  const json events = json::parse(trace.finish({})).at("events");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.at(0).at("type"), "source");
}

}  // namespace
}  // namespace wend
