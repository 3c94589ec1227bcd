// How fast cells with costs are searched. A* on maps of robots with a clearance cost, beside the
// yardstick of real_costs.hpp, and fields of costs to go. All times are CPU time of the thread.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/comparison/random_queries.hpp"
#include "bench/measure/markdown_table.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/suites/costs/real_costs.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/planner/planners.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend::bench {
namespace {

constexpr double kClearanceDistance = 0.35;  // m
constexpr double kResolution = 0.05;         // m a cell, of generated maps
constexpr std::uint64_t kSeed = 7;

std::vector<NamedMap> maps_of(const std::filesystem::path& folder) {
  std::vector<NamedMap> maps = loaded_maps({folder / "depot.yaml", folder / "100by100_10.yaml"});
  maps.push_back({"warehouse", in_metres(generated_map("warehouse", 1000, 1700), kResolution)});
  maps.push_back({"office", in_metres(generated_map("office", 1200, 900), kResolution)});
  return maps;
}

struct Measured {
  double microseconds;  // a query
  double expanded;
  double cost;  // of all paths
};

/// The least of `rounds` times for all queries.
template <class Answer>
Measured measured(const std::vector<CellPair>& pairs, int rounds, Answer&& answer) {
  Measured best{INFINITY, 0, 0};
  for (int round = 0; round < rounds; ++round) {
    Measured now{0, 0, 0};
    const double begun = thread_cpu_seconds();
    for (const CellPair& pair : pairs) answer(pair, now);
    now.microseconds = (thread_cpu_seconds() - begun) * 1e6 / static_cast<double>(pairs.size());
    now.expanded /= static_cast<double>(pairs.size());
    if (now.microseconds < best.microseconds) best = now;
  }
  return best;
}

Measured by_yardstick(const FreeSpace& space, const std::vector<CellPair>& pairs, int rounds) {
  const auto engine = real_cost_engine(space);
  const Limits limits;
  Path path;
  return measured(pairs, rounds, [&](const CellPair& pair, Measured& sum) {
    const GoalRegion goal(pair.goal);
    engine->begin(pair.start, {&goal, 1}, limits, nullptr);
    if (engine->run() != SearchOutcome::found) throw Wrong("no path between connected cells");
    engine->write_path(path);
    sum.expanded += static_cast<double>(engine->metrics().expanded);
    sum.cost += grid_path_cost(space, path.cells());
  });
}

Measured by_planner(const FreeSpace& space, const std::vector<CellPair>& pairs, int rounds,
                    const std::string& name, const OptionValues& options) {
  const auto planner = value_or_refuse(make_planner(name, space, options));
  Plan plan;
  return measured(pairs, rounds, [&](const CellPair& pair, Measured& sum) {
    if (planner->plan(Query::between(pair.start, pair.goal), plan) != Status::found) {
      throw Wrong("no path between connected cells");
    }
    sum.expanded += static_cast<double>(plan.metrics.expanded);
    sum.cost += plan.cost;
  });
}

double making_of(const std::string& name, const FreeSpace& space) {
  return seconds_of(thread_cpu_seconds, [&] { value_or_refuse(make_planner(name, space)); });
}

/// By how much of itself a cost is at most above that of the yardstick; infinite if a cell lacks a cost.
double greatest_excess(const Grid<double>& costs, const Grid<double>& yardstick) {
  double most = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const double expected = yardstick.values()[i];
    if (costs.values()[i] == expected) continue;
    most = std::max(most, costs.values()[i] / expected - 1);
  }
  return most;
}

/// Making the planner, and its first query.
double first_query(const FreeSpace& space, const CellPair& pair) {
  const double begun = thread_cpu_seconds();
  const auto planner = make_planner("astar", space);
  value_or_refuse((*planner)->plan(Query::between(pair.start, pair.goal)));
  return (thread_cpu_seconds() - begun) * 1e6;
}

void measure_queries(const std::vector<NamedMap>& maps, std::uint64_t queries, int rounds) {
  MarkdownTable table({{"map"},
                       {"doubles and heap, us"},
                       {"leaps=false, us"},
                       {"astar, us"},
                       {"first query, us"},
                       {"expanded before"},
                       {"expanded now"},
                       {"times as fast"},
                       {"alt, us"},
                       {"expanded by alt"},
                       {"times as fast"},
                       {"making alt, ms"},
                       {"dearer by"}});
  for (const NamedMap& named : maps) {
    const FreeSpace space =
        value_or_refuse(make_free_space(named.map, {.clearance_distance = kClearanceDistance}));
    const auto pairs = random_pairs(space, queries, kSeed);
    const Measured before = by_yardstick(space, pairs, rounds);
    const Measured stepwise = by_planner(space, pairs, rounds, "astar", {{"leaps", "false"}});
    const Measured now = by_planner(space, pairs, rounds, "astar", {});
    const double making = making_of("alt", space);
    const Measured alt = by_planner(space, pairs, rounds, "alt", {});
    table.add(
        {fmt::format("{} {} x {}", named.name, space.width(), space.height()),
         fmt::format("{:.0f}", before.microseconds), fmt::format("{:.0f}", stepwise.microseconds),
         fmt::format("{:.0f}", now.microseconds),
         fmt::format("{:.0f}", first_query(space, pairs.front())),
         fmt::format("{:.0f}", before.expanded), fmt::format("{:.0f}", now.expanded),
         fmt::format("{:.1f}", before.microseconds / now.microseconds),
         fmt::format("{:.0f}", alt.microseconds), fmt::format("{:.0f}", alt.expanded),
         fmt::format("{:.1f}", before.microseconds / alt.microseconds),
         fmt::format("{:.0f}", making * 1e3), fmt::format("{:.1g}", now.cost / before.cost - 1)});
  }
  fmt::print("{}", table.text());
}

/// Costs to go of all cells of a map, to a cell drawn at random.
std::vector<std::string> field_row(const std::string& name, const FreeSpace& space, int rounds) {
  const Cell goal = random_pairs(space, 1, kSeed).front().goal;
  const double begun = thread_cpu_seconds();
  const Grid<double> yardstick = real_costs_to_go(space, goal);
  const double before = thread_cpu_seconds() - begun;
  double least = INFINITY;
  double excess = 0;
  std::uint64_t expanded = 0;
  for (int round = 0; round < rounds; ++round) {
    const double started = thread_cpu_seconds();
    const CostToGo field = value_or_refuse(CostToGo::make(space, std::array{goal}));
    least = std::min(least, thread_cpu_seconds() - started);
    expanded = field.metrics().expanded;
    excess = greatest_excess(field.costs(), yardstick);
  }
  return {name,
          fmt::format("{:.0f}", before * 1e3),
          fmt::format("{:.0f}", least * 1e3),
          fmt::format("{}", expanded),
          fmt::format("{:.1f}", before / least),
          fmt::format("{:.1g}", excess)};
}

void measure_fields(int size, int rounds) {
  MarkdownTable table({{"cost to go"},
                       {"doubles and heap, ms"},
                       {"CostToGo, ms"},
                       {"cells"},
                       {"times as fast"},
                       {"dearer by, at most"}});
  for (const char* kind : {"rooms", "warehouse", "office"}) {
    const GridMap map = in_metres(generated_map(kind, size, size), kResolution);
    for (const double distance : {0.0, kClearanceDistance}) {
      const FreeSpace space = *make_free_space(map, {.clearance_distance = distance});
      table.add(field_row(
          fmt::format("{0} {1} x {1}, {2}", kind, size, distance == 0 ? "uniform" : "inflated"),
          space, rounds));
    }
  }
  fmt::print("\n{}", table.text());
}

}  // namespace

Measure add_costs(CLI::App& app) {
  struct Arguments {
    std::filesystem::path folder = data_folder() / "ros" / "nav2";
    std::uint64_t queries = 100;
    int rounds = 3;
    int field = 4096;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("--maps", arguments->folder, "folder with depot.yaml and 100by100_10.yaml")
      ->capture_default_str();
  app.add_option("--queries", arguments->queries,
                 "random connected pairs of cells for each map; 0: none")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  add_rounds(app, arguments->rounds);
  app.add_option("--field", arguments->field, "columns and rows of the maps of the fields; 0: none")
      ->check(CLI::Range(0, 16384))
      ->capture_default_str();
  return [arguments] {
    stay_on_one_core();
    if (arguments->queries > 0) {
      measure_queries(maps_of(arguments->folder), arguments->queries, arguments->rounds);
    }
    if (arguments->field > 0) measure_fields(arguments->field, arguments->rounds);
    return 0;
  };
}

}  // namespace wend::bench
