// Every failure that wend can word, made by a real request and compared with tests/failures/messages.txt word for word.
// WEND_WRITE_MESSAGES=1 writes the file anew: read the difference before you commit it.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/testing/build_paths.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/map/masked.hpp"
#include "wend/session/session.hpp"

namespace wend::test {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
std::string message_file() { return source_folder() / "tests/failures/messages.txt"; }

/// A map in cells, with a row of obstacles, unknown cells and a closed room.
constexpr std::string_view kYard = R"(
..............
.....#.....###
.....#..??.#.#
.....#..??.###
..............
)";
/// Two halves.
constexpr std::string_view kHalves = R"(
....#....
....#....
....#....
)";
constexpr std::string_view kUnknownHalves = R"(
....?....
....?....
....?....
)";
/// Two halves that touch at corners.
constexpr std::string_view kSlit = R"(
...#..
..#...
.#....
#.....
)";
/// A door of one cell.
constexpr std::string_view kDoor = R"(
.......#.......
.......#.......
.......#.......
...............
.......#.......
.......#.......
.......#.......
)";
/// A corner into which no car gets.
constexpr std::string_view kCorner = R"(
.#...
##...
.....
)";
/// The door of the room at the right is a bend, too tight for a long robot.
constexpr std::string_view kPocket = R"(
..............
.######.......
......#.......
.####.#.......
....#.#.......
....#.#.......
....###.......
)";

constexpr std::string_view kBox = "1.4,0.9; 1.4,-0.9; -1.4,-0.9; -1.4,0.9";

struct Case {
  std::string name;
  std::string_view drawing = kYard;
  PlanRequest request = {};
  FreeSpaceOptions robot = {};
  bool metres = false;
  std::string_view mask = {};
};

PlanRequest between(MapPose start, MapPose goal, PlannerSpec planner = {"astar"}) {
  PlanRequest request{.start = start, .goals = {{{goal.x, goal.y}}}};
  const PlannerInfo* const info = planners().find(planner.name);
  if (info != nullptr && info->capabilities.headings) request.goals.front().heading = goal.heading;
  request.planner = std::move(planner);
  return request;
}

FreeSpaceOptions disc(double radius) { return {.footprint = Footprint::disc(radius)}; }

FreeSpaceOptions box(OutsidePolicy outside = OutsidePolicy::blocked) {
  return {.footprint = *parse_footprint(kBox), .outside = outside};
}

PlannerSpec hybrid() { return {"hybrid_astar", {{"turning_radius", "2"}, {"time_budget", "100"}}}; }

template <class Change>
PlanRequest with(PlanRequest request, Change change) {
  change(request);
  return request;
}

/// In the middle of a cell of a map in cells.
MapPose at(int x, int y, double heading = 0) { return {x + 0.5, y + 0.5, heading}; }

std::vector<Case> ends_on_cells() {
  const auto from = [](MapPose start) { return between(start, at(1, 4)); };
  const auto to = [](MapPose goal) { return between(at(1, 4), goal); };
  return {
      {"start outside", kYard, from(at(20, 3))},
      {"start outside, NaN", kYard, from({kNoNumber, 1, 0})},
      {"goal outside", kYard, to(at(3, 9))},
      {"goal outside, with a tolerance", kYard,
       with(to(at(20, 3)), [](auto& r) { r.goals.front().tolerance = 2; })},
      {"start in an obstacle", kYard, from(at(5, 2))},
      {"goal in an obstacle", kYard, to(at(5, 2))},
      {"both ends blocked", kYard, between(at(5, 2), at(5, 3))},
      {"goal blocked within its tolerance", kYard,
       with(to(at(12, 2)), [](auto& r) { r.goals.front().tolerance = 0.4; }), disc(1)},
      {"start unknown", kYard, from(at(8, 2))},
      {"goal unknown", kYard, to(at(9, 3))},
      {"start too close", kYard, from(at(4, 2)), disc(1.5)},
      {"goal too close", kYard, to(at(6, 2)), disc(1.5)},
      {"start over the edge",
       kYard,
       from(at(0, 0)),
       {.footprint = Footprint::disc(1.2), .outside = OutsidePolicy::blocked}},
      {"goal over the edge",
       kYard,
       between(at(2, 2), at(13, 4)),
       {.footprint = Footprint::disc(1.2), .outside = OutsidePolicy::blocked}},
      {"a footprint counts as the disc around it", kYard, from(at(4, 2)), box()},
      {"start in a mask",
       kYard,
       from(at(2, 2)),
       {},
       false,
       "..............\n"
       "..#...........\n"
       "..#...........\n"
       "..............\n"
       "..............\n"},
      {"goal beside a mask", kYard, to(at(2, 3)), disc(1.4), false,
       "..............\n"
       "..............\n"
       "..#...........\n"
       "..............\n"
       "..............\n"},
  };
}

std::vector<Case> in_metres() {
  const auto half = [](double x, double y, double heading = 0) { return MapPose{x, y, heading}; };
  return {
      {"start outside, in metres", kYard, between(half(9, 1), half(1, 1)), {}, true},
      {"start in an obstacle, in metres", kYard, between(half(2.6, 1.1), half(1, 1)), {}, true},
      {"goal unknown, in metres", kYard, between(half(1, 1), half(4.2, 1.3)), {}, true},
      {"goal too close, in metres", kYard, between(half(1, 1), half(3.2, 1.2)), disc(0.6), true},
      {"walled in, in metres", kYard, between(half(1, 1), half(6.2, 1.3)), {}, true},
      {"stopped, in metres",
       kYard,
       with(between(half(1, 1), half(6.5, 0.2)), [](auto& r) { r.limits.expansions = 2; }),
       {},
       true},
      {"car blocked, in metres", kYard, between(half(2.5, 1), half(1, 1), {"car"}), {}, true},
      {"no drive, in metres", kHalves, between(half(0.7, 0.7), half(4, 0.7), hybrid()), {}, true},
      {"moved too far, in metres",
       kYard,
       with(between(half(1, 1), half(6.2, 1.3)),
            [](auto& r) {
              r.nearest = true;
              r.nearest_limit = 0.2;
            }),
       {},
       true},
      {"in words of cells",
       kYard,
       with(between(half(2.6, 1.1), half(1, 1)), [](auto& r) { r.wording = MapUnits::cells; }),
       {},
       true},
  };
}

std::vector<Case> no_path_on_cells() {
  const auto across = [](PlannerSpec planner = {"astar"}) {
    return between(at(1, 1), at(7, 1), std::move(planner));
  };
  const auto briefly = [](PlanRequest request) {
    request.explain = false;
    return request;
  };
  return {
      {"separated", kHalves, across()},
      {"separated, in short", kHalves, briefly(across())},
      {"separated by unknown cells", kUnknownHalves, across()},
      {"separated by corners that touch", kSlit, between(at(0, 0), at(5, 3))},
      {"separated for this robot", kDoor, between(at(3, 3), at(11, 3)), disc(1)},
      {"separated with a tolerance", kHalves,
       with(across(), [](auto& r) { r.goals.front().tolerance = 1; })},
      {"separated from two goals", kHalves,
       with(across(), [](auto& r) { r.goals.push_back({{6.5, 0.5}}); })},
      {"one goal blocked, one outside", kHalves,
       with(across(),
            [](auto& r) {
              r.goals.front().point = {4.5, 1.5};
              r.goals.push_back({{40, 1}});
            })},
      {"a walled cell", kYard, between(at(1, 4), at(12, 2))},
      {"a walled cell, moved too far", kYard,
       with(between(at(1, 4), at(12, 2)),
            [](auto& r) {
              r.nearest = true;
              r.nearest_limit = 0.5;
            })},
      {"a blocked goal, moved too far", kYard,
       with(between(at(1, 4), at(12, 2)),
            [](auto& r) {
              r.nearest = true;
              r.nearest_limit = 0.5;
            }),
       disc(1)},
      {"a start without a way out", kYard,
       with(between(at(12, 2), at(1, 4)), [](auto& r) { r.escape = 1; }), disc(1)},
      {"a way out that is too long", kYard,
       with(between(at(4, 2), at(1, 4)), [](auto& r) { r.escape = 0.1; }), disc(1.4)},
      {"a robot without room anywhere", kSlit, between(at(0, 0), at(5, 3)), disc(5)},
      {"jps: separated", kHalves, across({"jps"})},
      {"any_angle: separated", kHalves, across({"any_angle"})},
      {"hub_labels: separated", kHalves, across({"hub_labels"})},
  };
}

std::vector<Case> limits_and_requests() {
  static std::atomic<bool> cancelled = true;
  const auto way = [] { return between(at(0, 0), at(13, 4)); };
  const auto walk = [] {
    return between(at(0, 0), at(13, 4), {"random_walk", {{"max_steps", "3"}, {"seed", "1"}}});
  };
  return {
      {"expansions", kYard, with(way(), [](auto& r) { r.limits.expansions = 3; })},
      {"expansions, in short", kYard,
       with(way(),
            [](auto& r) {
              r.limits.expansions = 3;
              r.explain = false;
            })},
      {"cancelled", kYard, with(way(), [](auto& r) { r.limits.cancel = &cancelled; })},
      {"steps of a walk", kYard, walk()},
      {"no goal", kYard, with(way(), [](auto& r) { r.goals.clear(); })},
      {"tolerance below 0", kYard, with(way(), [](auto& r) { r.goals.front().tolerance = -1; })},
      {"tolerance NaN", kYard, with(way(), [](auto& r) { r.goals.front().tolerance = kNoNumber; })},
      {"seconds NaN", kYard, with(way(), [](auto& r) { r.limits.seconds = kNoNumber; })},
      {"keep below 0", kYard, with(way(), [](auto& r) { r.keep = -1; })},
      {"nearest_limit below 0", kYard, with(way(), [](auto& r) { r.nearest_limit = -1; })},
      {"escape NaN", kYard, with(way(), [](auto& r) { r.escape = kNoNumber; })},
      {"no such planner", kYard, with(way(), [](auto& r) { r.planner.name = "a_star"; })},
      {"no such option", kYard,
       with(way(), [](auto& r) { r.planner.options = {{"wieght", "2"}}; })},
      {"option out of range", kYard,
       with(way(), [](auto& r) { r.planner.options = {{"weight", "-2"}}; })},
      {"a field for a planner with headings", kYard,
       with(way(),
            [](auto& r) {
              r.planner = hybrid();
              r.from_field = true;
            })},
      {"a robot with a radius below 0", kYard, way(), disc(-1)},
  };
}

std::vector<Case> with_headings() {
  const auto drive = [](MapPose from, MapPose to) { return between(from, to, hybrid()); };
  const auto car = [](MapPose from, MapPose to) { return between(from, to, {"car"}); };
  const auto moves = [](MapPose from, MapPose to) { return between(from, to, {"lattice"}); };
  constexpr double kUp = kPi / 2;
  return {
      {"hybrid_astar: start outside", kYard, drive({30, 2, 0}, {2, 4, 0})},
      {"hybrid_astar: goal outside", kYard, drive({2, 4, 0}, {2, -4, 0})},
      {"hybrid_astar: start in an obstacle", kYard, drive(at(5, 2), {2, 4, 0})},
      {"hybrid_astar: goal unknown", kYard, drive({2, 4, 0}, at(8, 2))},
      {"hybrid_astar: a corner touches", kDoor, drive({5.8, 2, 0}, {2, 4, 0}), box()},
      {"hybrid_astar: over the edge", kDoor, drive({3, 3, 0}, {14.5, 3, 0}), box()},
      {"hybrid_astar: goal blocked, within its tolerance", kDoor,
       with(drive({3, 3, 0}, {7.5, 1.5, 0}), [](auto& r) { r.goals.front().tolerance = 0.3; }),
       box()},
      {"hybrid_astar: too close", kDoor, drive({6, 1.5, 0}, {2, 4, 0}), disc(1.5)},
      {"hybrid_astar: a robot larger than the map",
       kSlit,
       drive(at(0, 0), at(5, 3)),
       {.footprint = *parse_footprint("4,3; 4,-3; -4,-3; -4,3"),
        .outside = OutsidePolicy::blocked}},
      {"hybrid_astar: parted", kHalves, drive(at(1, 1), at(7, 1))},
      {"hybrid_astar: none found, on a lattice neither", kDoor, drive({3, 3.5, 0}, {11, 3.5, 0}),
       box()},
      {"hybrid_astar: parted by unknown cells", kUnknownHalves, drive(at(1, 1), at(7, 1))},
      {"hybrid_astar: none found",
       kPocket,
       drive({9, 3, 0}, {5.5, 5.5, 0}),
       {.footprint = *parse_footprint("0.45,0.2; 0.45,-0.2; -0.45,-0.2; -0.45,0.2"),
        .outside = OutsidePolicy::blocked}},
      {"hybrid_astar: any of two goals", kHalves,
       with(drive(at(1, 1), at(7, 1)), [](auto& r) { r.goals.push_back({{6.5, 0.5}, 0}); })},
      {"hybrid_astar: expansions", kYard,
       with(drive({2, 4, 0}, {12, 0.5, kUp}), [](auto& r) { r.limits.expansions = 2; })},
      {"hybrid_astar: heading NaN", kYard, drive({2, 4, kNoNumber}, {12, 4, 0})},
      {"hybrid_astar: heading of a goal NaN", kYard, drive({2, 4, 0}, {12, 4, kNoNumber})},
      {"car: start outside", kYard, car({30, 2, 0}, {2, 4, 0})},
      {"car: start blocked", kYard, car({5, 2, 0}, {2, 4, 0})},
      {"car: start moved to a vertex", kYard, car({5.3, 2.2, 0.1}, {2, 4, 0})},
      {"car: goal unknown", kYard, car({2, 4, 0}, {9, 2, 0})},
      {"car: separated", kHalves, car({1, 1, 0}, {7, 1, 0})},
      {"car: no move leaves the start", kCorner, car({0, 0, kUp}, {4, 2, 0})},
      {"car: no move reaches the goal", kCorner, car({4, 2, 0}, {0, 0, kUp})},
      {"car: too close", kDoor, car({6, 2, 0}, {2, 4, 0}), disc(1.5)},
      {"car: heading NaN", kYard, car({2, 4, kNoNumber}, {12, 4, 0})},
      {"lattice: start blocked", kYard, moves(at(5, 2), at(2, 4))},
      {"lattice: goal too close", kDoor, moves(at(3, 3), at(6, 1)), disc(1.5)},
      {"lattice: separated", kHalves, moves(at(1, 1), at(7, 1))},
      {"lattice: separated by unknown cells", kUnknownHalves, moves(at(1, 1), at(7, 1))},
      {"lattice: at no heading", kDoor,
       with(moves(at(3, 3), at(7, 1)), [](auto& r) { r.goals.front().heading.reset(); }), box()},
      {"lattice: a side crosses an obstacle", kDoor, moves(at(7, 3), at(2, 4)), box()},
  };
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (auto group :
       {ends_on_cells(), in_metres(), no_path_on_cells(), limits_and_requests(), with_headings()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

Hints hints() {
  return {.unknown_free = "--unknown free",
          .outside_free = "--outside free",
          .squeeze = "--corner-rule both",
          .robot_radius = "--robot-radius",
          .nearest = "--nearest",
          .nearest_limit = "--nearest-limit",
          .escape = "--escape",
          .explain = "`wend explain` shows where",
          .limit_expansions = "--limit-expansions",
          .limit_seconds = "--limit-time",
          .limit_steps = "--max-steps",
          .turning_radius = "--turning-radius",
          .allow_reverse = "--allow-reverse"};
}

GridMap map_of(const Case& made) {
  const Frame frame =
      made.metres ? Frame{.resolution = 0.5, .y_up = true, .metric = true} : Frame{};
  GridMap map = drawn_map(made.drawing, frame);
  if (made.mask.empty()) return map;
  return masked(map, drawn_map(made.mask, frame)).value();
}

struct Answered {
  Case made;
  Status status = Status::found;
  std::string message = {};
  Failure failure = {};
};

Answered answer_to(const Case& made) {
  Session session(map_of(made), made.robot, {.hints = hints()});
  const auto answer = session.plan(made.request);
  if (answer) return {made};
  return {made, answer.error().status, answer.error().message, answer.error().failure};
}

/// Made once for all tests.
const std::vector<Answered>& answers() {
  static const std::vector<Answered> all = [] {
    std::vector<Answered> made;
    for (const Case& each : cases()) made.push_back(answer_to(each));
    return made;
  }();
  return all;
}

std::string line_of(const Answered& answered) {
  return std::string(to_string(answered.status)) + ": " + answered.message;
}

/// Lines "name | status: message".
std::map<std::string, std::string> committed() {
  std::map<std::string, std::string> found;
  std::ifstream file{message_file()};
  for (std::string line; std::getline(file, line);) {
    const auto bar = line.find(" | ");
    if (bar != std::string::npos) found[line.substr(0, bar)] = line.substr(bar + 3);
  }
  return found;
}

TEST(FailureMessages, AreThoseOfTheList) {
  if (std::getenv("WEND_WRITE_MESSAGES") != nullptr) {
    std::ofstream file{message_file()};
    for (const Answered& each : answers()) file << each.made.name << " | " << line_of(each) << '\n';
  }
  auto expected = committed();
  EXPECT_GE(expected.size(), 60U);
  for (const Answered& each : answers()) {
    EXPECT_NE(each.status, Status::found) << each.made.name;
    EXPECT_EQ(line_of(each), expected[each.made.name]) << each.made.name;
    expected.erase(each.made.name);
  }
  for (const auto& [name, message] : expected) ADD_FAILURE() << "no request makes: " << name;
}

/// A list without a cause would not notice that its words are lost.
TEST(FailureMessages, CoverEveryCauseAndEveryStatusOfAQuery) {
  std::set<std::size_t> causes;
  std::set<Status> statuses;
  for (const Answered& each : answers()) {
    statuses.insert(each.status);
    for (const FailureCause& cause : each.failure.causes) causes.insert(cause.index());
  }
  for (const Status status :
       {Status::start_outside, Status::goal_outside, Status::start_blocked, Status::goal_blocked,
        Status::unreachable, Status::step_limit, Status::expansion_limit, Status::cancelled,
        Status::unsupported_query, Status::invalid_option}) {
    EXPECT_TRUE(statuses.contains(status)) << to_string(status);
  }
  // One depends on the time that a search takes, the other comes from planners of others.
  const std::set<std::size_t> left_out{FailureCause(OwnLimit{}).index(),
                                       FailureCause(OwnText{}).index()};
  for (std::size_t cause = 0; cause < std::variant_size_v<FailureCause>; ++cause) {
    EXPECT_NE(causes.contains(cause), left_out.contains(cause)) << "alternative " << cause;
  }
}

bool says(const std::string& message, std::string_view words) {
  return message.find(words) != std::string::npos;
}

/// The number behind a hint, if the message has it.
std::optional<double> number_behind(const std::string& message, const std::string& hint) {
  const auto found = message.find(hint + ' ');
  if (found == std::string::npos) return std::nullopt;
  return std::stod(message.substr(found + hint.size() + 1));
}

/// What a message recommends is done: a path that was to exist does, and a blocked end is blocked no more.
TEST(FailureMessages, RecommendWhatHelps) {
  int tried = 0;
  const auto expect_help = [&](const Case& made, const std::string& hint, Status before) {
    const Status after = answer_to(made).status;
    if (before == Status::unreachable) {
      EXPECT_EQ(after, Status::found) << made.name << ": " << hint;
    } else {
      EXPECT_NE(after, before) << made.name << ": " << hint;
    }
    ++tried;
  };
  for (const auto& [made, status, message, failure] : answers()) {
    if (says(message, "(--unknown free")) {
      Case changed = made;
      changed.robot.unknown = UnknownPolicy::free;
      expect_help(changed, "--unknown free", status);
    }
    if (says(message, "(--outside free allows it)") && !says(message, "Also, ")) {
      Case changed = made;
      changed.robot.outside = OutsidePolicy::free;
      expect_help(changed, "--outside free", status);
    }
    if (says(message, "(--corner-rule both)")) {
      Case changed = made;
      changed.request.planner.options.emplace_back("corner_rule", "both");
      expect_help(changed, "--corner-rule both", status);
    }
    if (const auto radius = number_behind(message, "(--robot-radius")) {
      Case changed = made;
      changed.robot.footprint = Footprint::disc(*radius);
      expect_help(changed, "--robot-radius", status);
    }
    if (const auto length = number_behind(message, "--escape")) {
      Case changed = made;
      changed.request.escape = *length;
      expect_help(changed, "--escape", status);
    }
    const auto limit = number_behind(message, "--nearest-limit");
    if (limit || says(message, "--nearest plans")) {
      Case changed = made;
      changed.request.nearest = true;
      if (limit) changed.request.nearest_limit = limit;
      expect_help(changed, "--nearest", status);
    }
  }
  EXPECT_GE(tried, 60);
}

}  // namespace
}  // namespace wend::test
