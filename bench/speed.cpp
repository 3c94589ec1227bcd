// wend-speed: our planners beside Boost's A*, on the scenarios of a folder.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "bench/measuring.hpp"
#include "bench/speed_run.hpp"

namespace wend::bench {
namespace {

void show_progress(const std::string& map, std::size_t done, std::size_t all) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K{}/{} {}", done + 1, all, map);
}

void end_progress() {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

std::size_t wrong_answers(const std::vector<MapTimings>& maps) {
  std::size_t wrong = 0;
  for (const MapTimings& map : maps) {
    wrong += map.boost.wrong;
    for (const Timing& timing : map.planners) wrong += timing.wrong;
  }
  return wrong;
}

void print_row(const Timing& timing, double ratio) {
  fmt::print("  {:<28} {:>10.1f} us {:>8.2f} x {:>10.0f} expanded {:>6.1f} M/s{}\n", timing.name,
             timing.mean_us, ratio, timing.expanded, timing.expanded / timing.mean_us,
             timing.wrong == 0 ? "" : fmt::format("  {} WRONG", timing.wrong));
}

void print_text(const std::vector<MapTimings>& maps, const SpeedPlan& plan) {
  for (const MapTimings& map : maps) {
    fmt::print("{}: {} free cells, {} queries, {:.0f} cells a path\n", map.map, map.free_cells,
               map.queries, map.path_cells);
    print_row(map.boost, 1);
    for (std::size_t i = 0; i < map.planners.size(); ++i) {
      print_row(map.planners[i], map.ratio(i));
    }
  }
  fmt::print("\n");
  for (std::size_t i = 0; i < plan.planners.size(); ++i) {
    fmt::print("speed {} / boost-astar = {:.2f} (geometric mean over {} maps)\n",
               plan.planners[i].text, geometric_mean_ratio(maps, i), maps.size());
  }
}

nlohmann::json to_json(const Timing& timing) {
  return {{"name", timing.name},
          {"mean_us", timing.mean_us},
          {"expanded_per_query", timing.expanded},
          {"wrong", timing.wrong}};
}

void print_json(const std::vector<MapTimings>& maps, const SpeedPlan& plan) {
  nlohmann::json out{{"maps", nlohmann::json::array()}, {"speed", nlohmann::json::object()}};
  for (const MapTimings& map : maps) {
    nlohmann::json row{{"map", map.map},
                       {"free_cells", map.free_cells},
                       {"queries", map.queries},
                       {"path_cells", map.path_cells},
                       {"boost", to_json(map.boost)},
                       {"planners", nlohmann::json::array()}};
    for (std::size_t i = 0; i < map.planners.size(); ++i) {
      nlohmann::json planner = to_json(map.planners[i]);
      planner["ratio"] = map.ratio(i);
      row["planners"].push_back(planner);
    }
    out["maps"].push_back(row);
  }
  for (std::size_t i = 0; i < plan.planners.size(); ++i) {
    out["speed"][plan.planners[i].text] = geometric_mean_ratio(maps, i);
  }
  fmt::print("{}\n", out.dump(2));
}

int run(const SpeedPlan& plan, bool json) {
  stay_on_one_core();
  const auto maps = run_speed(plan, show_progress);
  end_progress();
  if (!maps) {
    fmt::print(stderr, "{}\n", maps.error());
    return 2;
  }
  if (json) {
    print_json(*maps, plan);
  } else {
    print_text(*maps, plan);
  }
  return wrong_answers(*maps) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace wend::bench

int main(int argc, char** argv) {
  constexpr std::string_view kData = WEND_DATA;  // empty where the build found no data
  wend::bench::SpeedPlan plan;
  if (!kData.empty()) plan.folder = std::filesystem::path(kData) / "nine";
  std::string planners = "astar";
  std::string format = "text";
  CLI::App app("Times planners beside Boost.Graph's A*, query by query in turns, on one core.");
  app.add_option("folder", plan.folder, "pairs of .map and .map.scen files")
      ->required(kData.empty())
      ->capture_default_str();
  app.add_option("--planner", planners, "a list, as astar,dijkstra or astar:weight=2,bfs")
      ->capture_default_str();
  app.add_option("--sample", plan.sample, "queries a map, evenly spread")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--rounds", plan.rounds, "timed runs of every query; the fastest counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--format", format, "text or json")->check(CLI::IsMember({"text", "json"}));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  auto specs = wend::parse_planner_specs(planners);
  if (!specs) {
    fmt::print(stderr, "--planner: {}\n", specs.error().message());
    return 2;
  }
  plan.planners = *std::move(specs);
  return wend::bench::run(plan, format == "json");
}
