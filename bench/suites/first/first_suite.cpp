// The parts of the way from a map file to the first path on it.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measure/machine.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/scenario/scenario_queries.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/text_table.hpp"

namespace wend::bench {
namespace {

struct Arguments {
  std::filesystem::path folder;
  std::string planner = "jps";
  std::string yardstick = "astar";
  std::size_t sample = 10;  // queries a map
  int rounds = 5;           // the least time of each part counts
};

/// Seconds of CPU time.
struct Parts {
  double load = 0;
  double space = 0;
  double make = 0;
  double query = 0;

  double sum() const { return load + space + make + query; }

  /// Adds this share of others.
  void add(const Parts& parts, std::size_t count) {
    const auto share = 1 / static_cast<double>(count);
    load += share * parts.load;
    space += share * parts.space;
    make += share * parts.make;
    query += share * parts.query;
  }
};

struct Row {
  std::string map;
  int width = 0;
  int height = 0;
  Parts means{};
  Parts yardstick{};
  std::size_t without_path = 0;  // queries
};

/// Times all parts from the file to one path, without anything prepared. False if there is no path.
bool go(const std::filesystem::path& file, const std::string& name, const ScenarioQuery& query,
        Parts& least, Row& row) {
  std::optional<LoadedMap> loaded;
  std::optional<FreeSpace> space;
  std::unique_ptr<Planner> planner;
  Plan plan;
  Status status = Status::found;
  const Query asked = Query::between(query.start, query.goal);
  const Clock clock = thread_cpu_seconds;
  Parts parts;
  parts.load = seconds_of(clock, [&] { loaded = value_or_refuse(load_map(file)); });
  parts.space =
      seconds_of(clock, [&] { space = value_or_refuse(make_free_space(std::move(loaded->map))); });
  parts.make = seconds_of(clock, [&] { planner = value_or_refuse(make_planner(name, *space)); });
  parts.query = seconds_of(clock, [&] { status = planner->plan(asked, plan); });
  row.width = planner->free_space().width();
  row.height = planner->free_space().height();
  least = {std::min(least.load, parts.load), std::min(least.space, parts.space),
           std::min(least.make, parts.make), std::min(least.query, parts.query)};
  return status == Status::found;
}

Row row_of(const std::filesystem::path& scenario_file, const Arguments& arguments) {
  const auto scenario = value_or_refuse(load_scenario(scenario_file));
  const auto map_file = value_or_refuse(scenario_map_path(scenario));
  Row row{.map = map_file.stem().string()};
  const auto queries = evenly_sampled(scenario.queries, arguments.sample);
  for (const ScenarioQuery& query : queries) {
    constexpr double kNever = 1e9;
    Parts least{kNever, kNever, kNever, kNever};
    Parts yardstick = least;
    for (int round = 0; round < arguments.rounds; ++round) {  // in turns
      const bool found = go(map_file, arguments.planner, query, least, row);
      if (!found && round == 0) ++row.without_path;
      go(map_file, arguments.yardstick, query, yardstick, row);
    }
    row.means.add(least, queries.size());
    row.yardstick.add(yardstick, queries.size());
  }
  return row;
}

std::string table_of(const std::vector<Row>& rows, const std::string& yardstick) {
  TextTable table({{"map"},
                   {"cells", Align::right},
                   {"load\nms", Align::right},
                   {"free space\nms", Align::right},
                   {"planner\nms", Align::right},
                   {"first query\nms", Align::right},
                   {"sum\nms", Align::right},
                   {"times as fast\nas " + yardstick, Align::right},
                   {""}});
  const auto milliseconds = [](double seconds) { return fmt::format("{:.3f}", 1e3 * seconds); };
  for (const Row& row : rows) {
    const Parts& parts = row.means;
    table.add({row.map, fmt::format("{} x {}", row.width, row.height), milliseconds(parts.load),
               milliseconds(parts.space), milliseconds(parts.make), milliseconds(parts.query),
               milliseconds(parts.sum()), fmt::format("{:.2f}", row.yardstick.sum() / parts.sum()),
               row.without_path == 0 ? "" : fmt::format("{} WITHOUT A PATH", row.without_path)});
  }
  return table.text();
}

int run(const Arguments& arguments) {
  const auto scenarios = value_or_refuse(scenarios_in(arguments.folder));
  stay_on_one_core();
  std::vector<Row> rows;
  rows.reserve(scenarios.size());
  for (const std::filesystem::path& scenario : scenarios) {
    rows.push_back(row_of(scenario, arguments));
  }
  double logarithms = 0;
  for (const Row& row : rows) logarithms += std::log(row.yardstick.sum() / row.means.sum());
  fmt::print(
      "From a map file to the first path of {} for a point robot, everything new for each query.\n"
      "{} of the thread, least of {} rounds, mean of {} queries. {}.\n\n{}\n"
      "Geometric mean: {:.2f} times as fast as {}.\n",
      arguments.planner, thread_time_name(), arguments.rounds, arguments.sample, describe_machine(),
      table_of(rows, arguments.yardstick), std::exp(logarithms / static_cast<double>(rows.size())),
      arguments.yardstick);
  return std::ranges::any_of(rows, [](const Row& row) { return row.without_path > 0; }) ? 1 : 0;
}

}  // namespace

Measure add_first(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  const std::filesystem::path data = data_folder();
  if (!data.empty()) arguments->folder = data / "nine";
  CLI::Option* const folder =
      app.add_option("folder", arguments->folder, "pairs of .map and .map.scen files");
  folder->required(data.empty());
  if (!data.empty()) folder->capture_default_str();
  app.add_option("--planner", arguments->planner, "a planner's name")->capture_default_str();
  app.add_option("--yardstick", arguments->yardstick, "the planner beside it, in turns")
      ->capture_default_str();
  app.add_option("--sample", arguments->sample, "queries a map, evenly spread")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_rounds(app, arguments->rounds);
  return [arguments] { return run(*arguments); };
}

}  // namespace wend::bench
