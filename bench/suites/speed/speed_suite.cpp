// Our planners beside Boost's A*, on maps with scenarios.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "bench/measure/measuring.hpp"
#include "bench/suites/speed/speed_output.hpp"
#include "bench/suites/speed/speed_run.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_baseline.hpp"
#include "bench/suites/suite_maps.hpp"

namespace wend::bench {
namespace {

struct Arguments {
  std::filesystem::path folder;
  bool generated = false;
  std::string planners = "astar";
  SpeedPlan plan;
  std::string format = "text";
  std::string baseline;       // to compare with
  std::string save_baseline;  // to write
};

void show_progress(const std::string& map, std::size_t done, std::size_t all) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K{}/{} {}", done + 1, all, map);
}

void end_progress() {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

std::vector<PlannerSpec> parse_planners(const std::string& list) {
  auto specs = parse_planner_specs(list);
  if (!specs) throw Refused("--planner: " + specs.error().message);
  return *std::move(specs);
}

std::vector<MapTimings> timed(const std::vector<SpeedMap>& maps, const SpeedPlan& plan) {
  stay_on_one_core();
  auto timings = run_speed(maps, plan, show_progress);
  end_progress();
  return value_or_refuse(std::move(timings));
}

bool any_wrong(const std::vector<MapTimings>& maps) {
  return std::ranges::any_of(maps, [](const MapTimings& map) {
    return std::ranges::any_of(map.planners, [](const Timing& each) { return each.wrong > 0; });
  });
}

std::vector<BaselineRow> rows_of(const std::vector<MapTimings>& maps) {
  std::vector<BaselineRow> rows;
  for (std::size_t i = 1; i < maps.front().planners.size(); ++i) {
    const std::string& planner = maps.front().planners[i].name;
    const SpeedRatios ratios = ratios_of(maps, i);
    rows.push_back({planner, "later queries", ratios.later});
    rows.push_back({planner, "first query", ratios.first});
    rows.push_back({planner, "preparation", ratios.prepare});
  }
  return rows;
}

/// Compares the baseline's planners on the generated maps with the baseline.
int compare(Arguments arguments) {
  const Baseline baseline = value_or_refuse(read_baseline(arguments.baseline));
  std::string last;
  for (const BaselineRow& row : baseline.rows) {
    if (row.subject != last) {
      arguments.plan.planners.push_back(parse_planners(row.subject).front());
    }
    last = row.subject;
  }
  arguments.plan.sample = baseline.sample;
  const std::vector<MapTimings> maps = timed(generated_maps(), arguments.plan);
  const int slower = compare_with(baseline, rows_of(maps));
  return any_wrong(maps) ? 1 : slower;
}

int run(Arguments arguments) {
  if (!arguments.baseline.empty()) return compare(std::move(arguments));
  arguments.plan.planners = parse_planners(arguments.planners);
  const bool generated = arguments.generated || !arguments.save_baseline.empty();
  const std::vector<MapTimings> maps =
      timed(generated ? generated_maps() : value_or_refuse(maps_of_folder(arguments.folder)),
            arguments.plan);
  fmt::print("{}", arguments.format == "json" ? speed_json(maps)
                   : arguments.plan.fresh     ? fresh_text(maps)
                                              : speed_text(maps));
  if (!arguments.save_baseline.empty()) {
    save_baseline(arguments.save_baseline,
                  "times as fast as Boost.Graph's A* in the same run, geometric mean over the maps",
                  arguments.plan.sample, rows_of(maps));
  }
  return any_wrong(maps) ? 1 : 0;
}

}  // namespace

Measure add_speed(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  const std::filesystem::path data = data_folder();
  if (!data.empty()) arguments->folder = data / "nine";
  CLI::Option* const folder =
      app.add_option("folder", arguments->folder, "pairs of .map and .map.scen files");
  if (!data.empty()) folder->capture_default_str();
  app.add_flag("--generated", arguments->generated,
               "maps that are made from seeds, not a folder's");
  CLI::Option* const planner = app.add_option("--planner", arguments->planners,
                                              "a list, as astar,dijkstra or astar:weight=2,bfs")
                                   ->capture_default_str();
  app.add_flag("--fresh", arguments->plan.fresh,
               "time a planner made for each query, making it counted, on a space that planners "
               "share and on a new one; jps unless planners are named");
  app.add_option("--sample", arguments->plan.sample, "queries a map, evenly spread")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_rounds(app, arguments->plan.rounds);
  app.add_option("--format", arguments->format, "text or json")
      ->check(CLI::IsMember({"text", "json"}));
  app.add_option("--baseline", arguments->baseline,
                 "compare with the ratios in this file; exit code 1 if a planner got slower");
  app.add_option("--save-baseline", arguments->save_baseline,
                 "write the ratios on the generated maps to this file");
  return [arguments, folder, planner] {
    arguments->generated |= arguments->folder.empty();
    if (!folder->empty()) arguments->generated = false;
    if (arguments->plan.fresh && planner->empty()) arguments->planners = "jps";
    return run(*arguments);
  };
}

}  // namespace wend::bench
