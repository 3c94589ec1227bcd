#include "cli/developers/bench/settings.hpp"

#include <fmt/format.h>

#include <string_view>

#include "bench/measure/machine.hpp"
#include "cli/arguments/flags.hpp"
#include "wend/base/parse.hpp"
#include "wend/report/build_info.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kMostRepetitions = 1'000'000;
constexpr NumberRange kBenchSeconds{1e-6, 1e9, "s"};

std::string_view corner_text(CornerRule rule) {
  switch (rule) {
    case CornerRule::none:
      return "no corner cutting";
    case CornerRule::one:
      return "one corner may be cut";
    case CornerRule::both:
      return "both corners may be cut";
  }
  return {};
}

/// "radius 0.2", "footprint 0.4,0.25;0.4,-0.25;-0.3,0"
std::string shape_text(const Footprint& footprint, bool in_cells) {
  return (footprint.outline() ? "footprint " + text_of(footprint)
                              : "radius " + format_number(footprint.circumscribed_radius())) +
         (in_cells ? " cells" : "");
}

}  // namespace

void BenchSettings::add_to(Parser& app) {
  robot.add_robot_to(app);
  robot.add_clearance_cost_to(app);
  moves.add_to(app);
  add_count(app, "--threads", threads,
            "Number of threads that answer queries in parallel, each with its own planner (default "
            "1: threads share caches and slow each other down)");
  const Argument repeated =
      add_count(app, "--repetitions", repetitions,
                "Number of times that all queries are run, planner after planner (default 1)");
  add_count(app, "--passes", repetitions, "").former_name_of(repeated);
  app.add_flag("--fresh", fresh,
               wrapped("Make a new planner for every query and time its first query in one run; "
                       "the preparation time is shown beside it"));
  add_number(app, "--limit-time", limit_s, kBenchSeconds,
             "Limit on the CPU time of a query in seconds; a query that reaches it counts as timed "
             "out, not as wrong");
}

void BenchSettings::check(const Parser& app) const {
  check_range("--threads", threads, 1, kMostThreads);
  check_range(app.typed("--repetitions"), repetitions, 1, kMostRepetitions);
}

bool BenchSettings::as_in_scenarios() const {
  const FreeSpaceOptions chosen = robot.as_typed();
  return chosen.footprint.is_point() && chosen.clearance_distance == 0 &&
         chosen.unknown == UnknownPolicy::blocked && moves.moves == GridMoves{};
}

std::string BenchSettings::robot_text() const {
  const GridMoves& grid = moves.moves;
  const FreeSpaceOptions chosen = robot.as_typed();
  const Footprint& shape = chosen.footprint;
  std::string text = shape.is_point() ? "a point" : shape_text(shape, robot.cells);
  if (chosen.unknown == UnknownPolicy::free) text += ", enters unknown cells";
  if (chosen.outside == OutsidePolicy::blocked) text += ", stays on the map";
  if (chosen.outside == OutsidePolicy::free) text += ", may hang over the map's edge";
  if (chosen.clearance_distance > 0) {
    text +=
        fmt::format(", keeps {} away (cost {})", chosen.clearance_distance, chosen.clearance_cost);
  }
  if (grid.connectivity == Connectivity::four) return text + ", 4 neighbours";
  return fmt::format("{}, 8 neighbours, {}", text, corner_text(grid.corner_rule));
}

BenchConditions BenchSettings::conditions() const {
  return {.version = std::string(wend_version()),
          .commit = std::string(wend_commit()),
          .machine = describe_machine(),
          .robot = robot_text(),
          .fresh = fresh,
          .limit_s = limit_s.value_or(0)};
}

}  // namespace wend::cli
