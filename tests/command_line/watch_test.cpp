// `wend plan` where somebody watches the search: layers, lines, steps, films and traces.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/command_line/run_program.hpp"
#include "tests/command_line/terminal.hpp"
#include "tests/testing/drawn_map.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/animation/film_canvas.hpp"
#include "wend/render/animation/gif_test_support.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kWatchedGrid =
    ".....\n"
    ".##..\n"
    "...#.\n";
constexpr Cell kStart{0, 1};
constexpr Cell kGoal{4, 2};

std::size_t times_in(std::string_view text, std::string_view what) {
  std::size_t count = 0;
  for (auto at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

class Watching : public testing::Test {
 protected:
  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"plan", map_, "--start", "0,1", "--goal", "4,2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  Outcome plan(const std::vector<std::string>& more) const { return wend(arguments(more)); }

  /// With keys from standard input.
  Outcome step(const std::string& keys, const std::string& more = "") const {
    return shell("printf '" + keys + "' | \"$WEND\" plan '" + map_ +
                 "' --start 0,1 --goal 4,2 --step " + more);
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kWatchedGrid);
};

TEST_F(Watching, ShowsLayersAsAlignedGrids) {
  const Outcome outcome =
      plan({"--planner", "bfs", "--connectivity", "4", "--show", "g,parent,occupied"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("g, cost from the start\n"
                                           "1 2 3 4 5\n"
                                           "0 # # 5 6\n"
                                           "1 2 3 # 7\n"),
                                 HasSubstr("parent\n"
                                           "↓ ← ← ← ←\n"
                                           "S # # ↑ ←\n"
                                           "↑ ← ← # G\n"),
                                 HasSubstr("occupied\n"
                                           "0 0 0 0 0\n"
                                           "0 # # 0 0\n"
                                           "0 0 0 # 0\n")));
}

TEST_F(Watching, TakesEveryLayerByItsName) {
  for (const auto& choice : choice_names(LayerKind{})) {
    const Outcome outcome = plan({"--show", std::string(choice.name)});
    EXPECT_EQ(outcome.code, 0) << choice.name << ": " << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(std::string(title_of(choice.value))));
  }
  const Outcome unknown = plan({"--show", "expansions"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, AllOf(HasSubstr("--show"), HasSubstr("'expansions'"),
                                 HasSubstr("expansion, generation, g, heuristic")));
}

/// Without a search there is nothing that it knew, nor goals to estimate the way to.
TEST_F(Watching, ShowsNoLayersOfASearchThatNeverBegan) {
  const Outcome outcome =
      wend({"plan", map_, "--start", "1,1", "--goal", "4,2", "--show", "heuristic,expansion,cost"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(Not(HasSubstr("estimate")), Not(HasSubstr("expansion")),
                                 HasSubstr("cost to the goal")));
}

TEST_F(Watching, GivesLayersToPrograms) {
  const Outcome outcome =
      plan({"--show", "expansion,heuristic,frontier,policy", "--format", "json"});
  const json layers = json::parse(outcome.out).at("layers");
  const FreeSpace space = drawn_space(kWatchedGrid);
  const auto planner = make_planner("astar", space);
  SearchRecorder recorder(space);
  Query query = Query::between(kStart, kGoal);
  query.observer = &recorder;
  ASSERT_TRUE((*planner)->plan(query));
  for (const LayerKind kind : {LayerKind::expansion, LayerKind::heuristic, LayerKind::frontier}) {
    const Layer layer = search_layer(kind, **planner, recorder);
    const json& rows = layers.at(std::string(choice_name(kind)));
    ASSERT_EQ(rows.size(), 3U);
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 5; ++x) {
        const json& value = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        const double expected = layer.numbers[{x, y}];
        if (std::isnan(expected)) {
          EXPECT_TRUE(value.is_null()) << choice_name(kind) << " " << x << "," << y;
        } else {
          EXPECT_EQ(value, expected) << choice_name(kind) << " " << x << "," << y;
        }
      }
    }
  }
  EXPECT_EQ(layers.at("policy")[0][4], "down");
  EXPECT_TRUE(layers.at("policy")[2][4].is_null());
}

TEST_F(Watching, DrawsLayersSideBySide) {
  const std::string one = folder_ / "one.png";
  const std::string two = folder_ / "two.svg";
  EXPECT_EQ(plan({"--show", "clearance", "-o", one}).code, 0);
  EXPECT_EQ(plan({"--show", "expansion,policy", "-o", two, "--style", "dark"}).code, 0);
  EXPECT_THAT(bytes_of(one), StartsWith("\x89PNG"));
  EXPECT_THAT(bytes_of(two), HasSubstr("<svg"));
}

TEST_F(Watching, TellsEveryEventOnStandardError) {
  const Outcome outcome = plan({"--verbose", "--format", "json"});
  const json metrics = json::parse(outcome.out).at("metrics");
  EXPECT_THAT(outcome.err, StartsWith("  generate (0,1) f="));
  EXPECT_THAT(outcome.err, HasSubstr("\nexpand (0,1) f="));
  EXPECT_THAT(outcome.err, HasSubstr(" g=0 h="));
  EXPECT_EQ(times_in(outcome.err, "expand ("), metrics.at("expanded").get<std::size_t>());
  EXPECT_EQ(times_in(outcome.err, "generate ("), metrics.at("generated").get<std::size_t>());
}

TEST_F(Watching, WaitsForAKeyAfterEachExpansion) {
  const Outcome outcome = step("nn ", "--show g");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("expansion 1: (0,1)"), HasSubstr("expansion 2: "),
                                 HasSubstr("expansion 4: "), Not(HasSubstr("expansion 5: "))))
      << "three keys, and the end of the input runs on";
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("g, cost from the start\n"), HasSubstr("quality")));
}

TEST_F(Watching, RunsToTheEndOrLeapsOrQuitsWhenAsked) {
  const Outcome to_the_end = step("r");
  EXPECT_EQ(to_the_end.code, 0);
  EXPECT_THAT(to_the_end.out, AllOf(HasSubstr("expansion 1:"), Not(HasSubstr("expansion 2:"))));
  const Outcome shortcut = step("t", "--planner dijkstra");
  EXPECT_EQ(shortcut.code, 0);
  EXPECT_THAT(shortcut.out, AllOf(HasSubstr("expansion 1:"), Not(HasSubstr("expansion 2:")),
                                  HasSubstr("expansion 11:")));
  const Outcome quit = step("nq");
  EXPECT_EQ(quit.code, 1);
  EXPECT_THAT(quit.err, HasSubstr("cancelled after 2 expansions"));
}

TEST_F(Watching, GoesBackAsWellAsOn) {
  const Outcome outcome = step("nn\\177\\177n\\033[Dq", "--show g");
  EXPECT_EQ(outcome.code, 1);
  const auto place = [&outcome](const std::string& text, std::size_t from) {
    const auto at = outcome.out.find(text, from);
    EXPECT_NE(at, std::string::npos) << text << " after " << from;
    return at;
  };
  std::size_t at = 0;
  for (const int expansions : {1, 2, 3, 2, 1, 2, 1}) {
    at = place("expansion " + std::to_string(expansions) + ": ", at) + 1;
  }
  EXPECT_EQ(outcome.out.find("expansion ", at), std::string::npos);
  EXPECT_THAT(outcome.err, HasSubstr("cancelled after 1 expansion"));
}

/// What is shown of a moment does not depend on how one got there.
TEST_F(Watching, ShowsTheSameMomentAgainWhenItGoesBack) {
  for (const std::string planner : {"astar", "bfs", "jps", "random_walk"}) {
    const std::string more = "--show g,frontier --planner " + planner;
    const auto frame = [](const Outcome& outcome, int expansions, bool last) {
      const std::string text = "expansion " + std::to_string(expansions) + ": ";
      const auto at = last ? outcome.out.rfind(text) : outcome.out.find(text);
      const auto end = outcome.out.find('\n', at);
      const auto keys = outcome.out.rfind("q: quit\n", at);
      const auto begin = keys == std::string::npos ? 0 : keys + 9;
      return outcome.out.substr(begin, end - begin);
    };
    const Outcome outcome = step("nn\\033[D\\033[Dq", more);
    EXPECT_EQ(frame(outcome, 1, false), frame(outcome, 1, true)) << planner;
    EXPECT_EQ(frame(outcome, 2, false), frame(outcome, 2, true)) << planner;
    EXPECT_THAT(step("n\\033[Hq", more).out, HasSubstr("expansion 0: not begun, frontier 1\n"));
    EXPECT_EQ(times_in(step("nnTnq", more).out, "expansion 1: "), 2U) << planner;
  }
}

TEST_F(Watching, TellsEveryEventOnceThoughItGoesBack) {
  const Outcome there = step("nnnnr", "--verbose --open-list");
  const Outcome and_back = step("nn\\033[Dnn\\033[H\\033[Cr", "--verbose --open-list");
  EXPECT_EQ(and_back.code, 0);
  EXPECT_EQ(and_back.err, there.err);
  EXPECT_THAT(there.err, HasSubstr("expand (0,1)"));
}

TEST_F(Watching, ShowsTheOpenListWhileItSteps) {
  const Outcome outcome = step("q");
  EXPECT_THAT(outcome.out,
              HasSubstr("open list: 2, next entry first\n    x  y  g        h        f  tie\n 1  0 "
                        " 2  1        4        5\n 2  0  0  1  4.82843  5.82843\n"));
}

TEST_F(Watching, PrintsTheOpenListBeforeEachExpansion) {
  const Outcome outcome = plan({"--planner", "bfs", "--verbose", "--open-list"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(
      outcome.err,
      StartsWith(
          "  generate (0,1) f=0 g=0 h=0\nopen list: 1, next entry first\n    x  y  g  h  f  tie\n "
          "1  0  1  0  0  0\nexpand (0,1) f=0 g=0 h=0\n  generate (0,2) from (0,1) f=1 g=1 h=0\n  "
          "generate (0,0) from (0,1) f=1 g=1 h=0\nopen list: 2, next entry first\n    x  y  g  h  "
          "f  tie\n 1  0  2  1  0  1\n 2  0  0  1  0  1\nexpand (0,2)"));
  EXPECT_EQ(times_in(outcome.err, "open list:"), times_in(outcome.err, "expand "));
  const Outcome alone = plan({"--open-list"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_THAT(alone.err, HasSubstr("--open-list needs --verbose"));
}

TEST_F(Watching, ShowsTheHeadingsOfACarsOpenList) {
  const Outcome outcome = shell("printf q | \"$WEND\" plan '" + map_ +
                                "' --planner car --start 0,0,E --goal 4,1,any --step");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("x  y  heading"));
}

TEST_F(Watching, StepsThroughEveryPlanner) {
  for (const PlannerInfo& info : planners()) {
    if (info.capabilities.headings) continue;
    const Outcome outcome = step("nnq", "--planner " + info.name);
    EXPECT_EQ(outcome.code, info.capabilities.can_step ? 1 : 2) << info.name << ": " << outcome.err;
    EXPECT_EQ(times_in(outcome.out, "expansion 3:"), info.capabilities.can_step ? 1U : 0U);
  }
}

TEST_F(Watching, PlaysFilmsOnATerminalOnly) {
  const Outcome outcome = plan({"--animate"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("-o search.gif"));
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(plan({"--speed", "0"}).code, 2);
}

TEST_F(Watching, KeepsStepsApartFromJson) {
  const Outcome outcome = step("r", "--format json");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--step cannot be combined with --format json"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

/// What a terminal of 80 x 24 characters is told while somebody types keys; frame by frame.
class OnATerminal : public Watching {
 protected:
  void SetUp() override {
    if (shell("command -v script").code != 0) GTEST_SKIP() << "there is no script(1)";
  }

  std::vector<std::string> frames(const std::string& arguments, const std::string& keys,
                                  int columns = 80) const {
    const std::string log = folder_ / "log";
    shell("printf '" + keys +
          "' | env -u NO_COLOR TERM=xterm-256color script -qec \"stty rows 24 " + "cols " +
          std::to_string(columns) + "; $WEND plan " + arguments + "\" " + log + " >/dev/null");
    const std::string seen = bytes_of(log);
    const std::string home = "\x1b[H";
    std::vector<std::string> frames;
    for (auto at = seen.find(home); at != std::string::npos;) {
      const auto next = seen.find(home, at + 1);
      frames.push_back(seen.substr(at, next == std::string::npos ? next : next - at));
      at = next;
    }
    return frames;
  }

  std::string high_query() const {
    std::string grid;
    for (int y = 0; y < 30; ++y) grid += std::string(70, '.') + "\n";
    return folder_.write("high.txt", grid) + " --start 1,1 --goal 60,20";
  }

  std::string low_query() const { return map_ + " --start 0,1 --goal 4,2"; }
};

TEST_F(OnATerminal, StepsNeverScroll) {
  for (const std::string& query : {high_query(), low_query()}) {
    for (const char* layers : {"", " --show g", " --show parent,g,f,closed,frontier,expansion"}) {
      const auto seen = frames(query + " --step" + layers, "nntq");
      ASSERT_GE(seen.size(), 4U) << query << layers;
      for (const std::string& frame : seen) {
        const auto end = frame.find("q: quit");
        if (end == std::string::npos) continue;
        EXPECT_LT(times_in(frame.substr(0, end), "\n"), 23U) << query << layers << "\n" << frame;
      }
    }
  }
}

TEST_F(OnATerminal, StepsShowTheOpenListBesideTheMapOrBelowOnANarrowTerminal) {
  std::string grid;
  for (int y = 0; y < 20; ++y) grid += std::string(12, '.') + "\n";
  const std::string tall = folder_.write("tall.txt", grid) + " --start 1,1 --goal 8,18";
  const auto wide = frames(tall + " --step", "nq");
  ASSERT_FALSE(wide.empty());
  EXPECT_THAT(wide.front(), HasSubstr("   open list: "));
  const auto narrow = frames(low_query() + " --step", "nq", 30);
  ASSERT_FALSE(narrow.empty());
  EXPECT_THAT(narrow.front(), AllOf(HasSubstr("\x1b[K\r\nopen list: "), HasSubstr("q: quit")));
}

TEST_F(Watching, EndsStepsCleanlyWithCtrlC) {
  PseudoTerminal terminal(80, 24);
  const termios before = terminal.settings();
  terminal.start({"plan", map_, "--start", "0,1", "--goal", "4,2", "--step"});
  terminal.read_until("q: quit");
  terminal.type("n");
  terminal.read_until("expansion 2: ");
  EXPECT_EQ(terminal.settings().c_lflag & ECHO, 0U) << "keys are not echoed meanwhile";
  terminal.type("\x03");
  EXPECT_EQ(terminal.finish(), 130);
  EXPECT_THAT(terminal.seen(),
              AllOf(HasSubstr("\x1b[?25h"), HasSubstr("cancelled after 2 expansions")));
  const termios after = terminal.settings();
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  EXPECT_EQ(after.c_cc[VMIN], before.c_cc[VMIN]);
}

TEST_F(OnATerminal, StepsShowLayersBesideTheMap) {
  const auto seen = frames(low_query() + " --step --show g --planner bfs --connectivity 4", "q");
  ASSERT_FALSE(seen.empty());
  EXPECT_THAT(seen.front(), HasSubstr("   g, cost from the start"));
  EXPECT_EQ(times_in(seen.back(), "S start"), 1U) << "quitting leaves the last frame alone";
}

TEST_F(OnATerminal, StepsEndWithTheOutcomeAlone) {
  const std::string last = frames(low_query() + " --step", "nr").back();
  EXPECT_THAT(last, AllOf(HasSubstr("quality"), HasSubstr("→ path"), Not(HasSubstr("any key"))));
}

TEST_F(OnATerminal, FilmsFitAndAreNotFollowedByTheSamePicture) {
  for (const std::string& query : {high_query(), low_query()}) {
    const auto seen = frames(query + " --animate --speed 1e6", "");
    ASSERT_GE(seen.size(), 2U);
    EXPECT_LT(times_in(seen.front(), "\n"), 24U);
    EXPECT_THAT(seen.back(), AllOf(HasSubstr("quality"), HasSubstr("\x1b[?25h")));
    EXPECT_EQ(times_in(seen.back(), " goal"), 1U) << seen.back();
  }
}

/// What the last frame of a film shows.
Scene outcome_scene() {
  const FreeSpace space = drawn_space(kWatchedGrid);
  const auto planner = make_planner("astar", space);
  SearchRecorder recorder(space);
  Query query = Query::between(kStart, kGoal);
  query.observer = &recorder;
  const auto plan = (*planner)->plan(query);
  const SearchSnapshot last = recorder.snapshot();
  BitGrid current(space.width(), space.height());
  current.set(*last.current, true);
  Scene scene{.space = space, .path = plan->path};
  scene.start = centre_of(kStart);
  scene.goals = {centre_of(kGoal)};
  scene.marked = {{CellRole::expanded, last.expanded},
                  {CellRole::frontier, last.frontier},
                  {CellRole::current, current}};
  return scene;
}

/// The largest difference of two pictures in any colour channel.
int difference(const Image& a, const Image& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const unsigned shift : {0U, 8U, 16U}) {
      const auto channel = [&](const Image& image) {
        return static_cast<int>((image.values()[i] >> shift) & 255U);
      };
      most = std::max(most, std::abs(channel(a) - channel(b)));
    }
  }
  return most;
}

TEST_F(Watching, KeepsTheSearchAsAFilm) {
  const std::string film = folder_ / "search.gif";
  const Outcome outcome = plan({"-o", film, "--speed", "20", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto expanded = json::parse(outcome.out).at("metrics").at("expanded").get<std::size_t>();
  const Decoded decoded = test::decoded(bytes_of(film));
  // 20 expansions and 20 frames a second: one before each expansion, the end, and the outcome.
  EXPECT_EQ(decoded.frames.size(), expanded + 2);
  const Scene scene = outcome_scene();
  const FilmPanel panel{"astar", std::to_string(expanded) + " expanded", scene};
  FilmCanvas canvas(std::span(&panel, 1), legend_of(scene, {}), 800, 640, {});
  const Image& expected = canvas.draw(std::span(&panel, 1));
  const Image& last = decoded.frames.back().image;
  ASSERT_EQ(last.width(), expected.width());
  ASSERT_EQ(last.height(), expected.height());
  EXPECT_LE(difference(last, expected), 64) << "a GIF has 256 colours";
  EXPECT_GT(difference(decoded.frames.front().image, expected), 100);
}

TEST_F(Watching, WritesATraceWithALimit) {
  const std::string all = folder_ / "all.trace.json";
  const Outcome outcome = plan({"--trace", all, "--format", "json"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  const json trace = json::parse(bytes_of(all));
  const auto expanding = [](const json& events) {
    std::size_t count = 0;
    for (const json& event : events) count += event.at("type") == "expanding" ? 1 : 0;
    return count;
  };
  EXPECT_EQ(expanding(trace.at("events")),
            json::parse(outcome.out).at("metrics").at("expanded").get<std::size_t>());

  const std::string few = folder_ / "few.trace.yaml";
  const Outcome limited = plan({"--trace", few, "--trace-limit", "5"});
  EXPECT_EQ(limited.code, 0);
  EXPECT_THAT(limited.err, AllOf(HasSubstr("few.trace.yaml"), HasSubstr("truncated after 5 events"),
                                 HasSubstr("--trace-limit")));
  EXPECT_THAT(bytes_of(few), StartsWith("version: 1.4.0"));
}

TEST_F(Watching, RefusesATraceThatPosthocWouldNotOpen) {
  const Outcome name = plan({"--trace", folder_ / "trace.txt"});
  EXPECT_EQ(name.code, 2);
  EXPECT_THAT(name.err, HasSubstr(".trace.yaml or .trace.json"));
  const Outcome folder = plan({"--trace", "/no/such/folder/a.trace.yaml"});
  EXPECT_EQ(folder.code, 2);
  EXPECT_THAT(folder.err, HasSubstr("the folder /no/such/folder does not exist"));
}

}  // namespace
}  // namespace wend::test
