// wend-first: the parts of the way from a map file to the first path on it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measure/machine.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/scenario/scenario_queries.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/text_table.hpp"

namespace wend::bench {
namespace {

struct Arguments {
  std::filesystem::path folder;
  std::string planner = "jps";
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
};

struct Row {
  std::string map;
  int width = 0;
  int height = 0;
  Parts means{};
  std::size_t without_path = 0;  // queries
};

/// Calls `action` and returns the seconds that it took.
template <class Action>
double timed(Action&& action) {
  const double begin = thread_cpu_seconds();
  action();
  return thread_cpu_seconds() - begin;
}

/// Times all parts from the file to one path, without anything prepared. False if there is no path.
Expected<bool, Error> go(const std::filesystem::path& file, const Arguments& arguments,
                         const ScenarioQuery& query, Parts& least, Row& row) {
  Expected<LoadedMap, Error> loaded = failure(Status::invalid_file, "not loaded", "");
  Parts parts;
  parts.load = timed([&] { loaded = load_map(file); });
  if (!loaded) return Unexpected<Error>(loaded.error());
  Expected<FreeSpace, Error> space = failure(Status::invalid_file, "not made", "");
  parts.space = timed([&] { space = make_free_space(std::move(loaded->map)); });
  if (!space) return Unexpected<Error>(space.error());
  PlannerResult planner;
  parts.make = timed([&] { planner = make_planner(arguments.planner, *space); });
  if (!planner) return Unexpected<Error>(planner.error());
  Plan plan;
  Status status = Status::found;
  parts.query =
      timed([&] { status = (*planner)->plan(Query::between(query.start, query.goal), plan); });
  row.width = space->width();
  row.height = space->height();
  least = {std::min(least.load, parts.load), std::min(least.space, parts.space),
           std::min(least.make, parts.make), std::min(least.query, parts.query)};
  return status == Status::found;
}

Expected<Row, Error> row_of(const std::filesystem::path& scenario_file,
                            const Arguments& arguments) {
  const auto scenario = load_scenario(scenario_file);
  if (!scenario) return Unexpected<Error>(scenario.error());
  const auto map_file = scenario_map_path(*scenario);
  if (!map_file) return Unexpected<Error>(map_file.error());
  Row row{.map = map_file->stem().string()};
  const auto queries = evenly_sampled(scenario->queries, arguments.sample);
  for (const ScenarioQuery& query : queries) {
    constexpr double kNever = 1e9;
    Parts least{kNever, kNever, kNever, kNever};
    for (int round = 0; round < arguments.rounds; ++round) {
      const auto found = go(*map_file, arguments, query, least, row);
      if (!found) return Unexpected<Error>(found.error());
      if (!*found && round == 0) ++row.without_path;
    }
    const auto count = static_cast<double>(queries.size());
    row.means.load += least.load / count;
    row.means.space += least.space / count;
    row.means.make += least.make / count;
    row.means.query += least.query / count;
  }
  return row;
}

std::string table_of(const std::vector<Row>& rows) {
  TextTable table({{"map"},
                   {"cells", Align::right},
                   {"load\nms", Align::right},
                   {"free space\nms", Align::right},
                   {"planner\nms", Align::right},
                   {"first query\nms", Align::right},
                   {"sum\nms", Align::right},
                   {""}});
  const auto milliseconds = [](double seconds) { return fmt::format("{:.3f}", 1e3 * seconds); };
  for (const Row& row : rows) {
    const Parts& parts = row.means;
    table.add({row.map, fmt::format("{} x {}", row.width, row.height), milliseconds(parts.load),
               milliseconds(parts.space), milliseconds(parts.make), milliseconds(parts.query),
               milliseconds(parts.sum()),
               row.without_path == 0 ? "" : fmt::format("{} WITHOUT A PATH", row.without_path)});
  }
  return table.text();
}

int run(const Arguments& arguments) {
  const auto fail = [](const Error& error) {
    fmt::print(stderr, "wend-first: {}\n", error.message);
    return 2;
  };
  const auto scenarios = scenarios_in(arguments.folder);
  if (!scenarios) return fail(scenarios.error());
  stay_on_one_core();
  std::vector<Row> rows;
  for (const std::filesystem::path& scenario : *scenarios) {
    const auto row = row_of(scenario, arguments);
    if (!row) return fail(row.error());
    rows.push_back(*row);
  }
  fmt::print(
      "From a map file to the first path of {} for a point robot, everything new for each query.\n"
      "{} of the thread, least of {} rounds, mean of {} queries. {}.\n\n{}",
      arguments.planner, thread_time_name(), arguments.rounds, arguments.sample, describe_machine(),
      table_of(rows));
  return std::ranges::any_of(rows, [](const Row& row) { return row.without_path > 0; }) ? 1 : 0;
}

}  // namespace
}  // namespace wend::bench

int main(int argc, char** argv) {
  const std::filesystem::path data = WEND_DATA;  // empty where the build found no data
  wend::bench::Arguments arguments;
  if (!data.empty()) arguments.folder = data / "nine";
  CLI::App app("Times the parts of the way from a map file to the first path, in CPU time.");
  CLI::Option* folder =
      app.add_option("folder", arguments.folder, "pairs of .map and .map.scen files");
  folder->required(data.empty());
  if (!data.empty()) folder->capture_default_str();
  app.add_option("--planner", arguments.planner, "a planner's name")->capture_default_str();
  app.add_option("--sample", arguments.sample, "queries a map, evenly spread")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--rounds", arguments.rounds, "the least time of each part counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return wend::bench::run(arguments);
}
