// wend generate scenario: queries on a map, with the length of a shortest path for each.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bench/scenario/scenario_queries.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/arguments/search_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

constexpr std::uint64_t kMostBuckets = 1'000'000;
constexpr std::uint64_t kMostPerBucket = 10'000;

struct ScenarioArguments {
  MapArguments map;
  MovesArguments moves;
  std::uint64_t buckets = kMostBuckets;
  std::uint64_t per_bucket = ScenarioPlan{}.per_bucket;
  std::uint64_t seed = 1;
  Format format = Format::text;
  OutputFiles output;
};

constexpr const char* kExamples = R"(Examples:
  wend generate rooms --size 128x128 --seed 3 -o rooms.map
  wend generate scenario rooms.map --buckets 10 --seed 1 -o rooms.map.scen
  wend bench rooms.map.scen --planner astar,jps

Queries in MovingAI's format: pairs of connected cells, and the optimal cost
found by Dijkstra's algorithm. Bucket 0 has lengths below 4 cells, bucket 1
lengths below 8, and so on. Cells are numbered as with --cells: from the upper
left cell, on ROS maps from the lower left cell. The last buckets may have fewer
queries than requested, and a small map may have fewer buckets. Exit codes: 0
written, 2 bad usage or input.)";

std::vector<ScenarioQuery> make_queries(const ScenarioArguments& arguments, const GridMap& map) {
  const FreeSpace space = arguments.map.free_space(map);
  const ScenarioPlan plan{arguments.seed, arguments.buckets, arguments.per_bucket};
  auto queries = scenario_queries(space, arguments.moves.moves, plan);
  if (!queries) throw InputError(std::string(describe(queries.error())));
  if (queries->empty()) {
    throw InputError(fmt::format("{}: no two cells are connected", arguments.map.file));
  }
  const std::string name = std::filesystem::path(arguments.map.file).filename().string();
  if (name.find_first_of("\t\r\n") != std::string::npos) {
    throw InputError(
        fmt::format("{}: a scenario cannot hold a name with tabs or line ends", quote(name)));
  }
  for (ScenarioQuery& query : *queries) query.map = name;
  return *std::move(queries);
}

std::string json_of(const ScenarioArguments& arguments, const std::vector<ScenarioQuery>& queries) {
  const nlohmann::ordered_json json{
      {"map", arguments.map.file},        {"seed", arguments.seed},
      {"queries", queries.size()},        {"buckets", queries.back().bucket + 1},
      {"longest", queries.back().length}, {"files", arguments.output.files()}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string text_of(const ScenarioArguments& arguments, const std::vector<ScenarioQuery>& queries) {
  if (arguments.output.files().empty()) return format_scenario(queries);
  const int buckets = queries.back().bucket + 1;
  return fmt::format("{} queries in {} bucket{} on {}, seed {}\n", queries.size(), buckets,
                     buckets == 1 ? "" : "s", visible(arguments.map.file), arguments.seed);
}

int run(const ScenarioArguments& arguments) {
  arguments.output.check();
  check_range("--buckets", arguments.buckets, 1, kMostBuckets);
  check_range("--per-bucket", arguments.per_bucket, 1, kMostPerBucket);
  const LoadedMap loaded = arguments.map.load_map();
  arguments.output.check_not_among(loaded.files);
  const std::vector<ScenarioQuery> queries = make_queries(arguments, loaded.map);
  arguments.output.write_all(
      [&](const std::string& file) { return write_bytes(file, format_scenario(queries)); });
  print(arguments.format == Format::json ? json_of(arguments, queries)
                                         : text_of(arguments, queries));
  return success;
}

}  // namespace

Command add_generate_scenario(Parser& generate) {
  Parser scenario = generate.add_subcommand("scenario", "Generate a MovingAI scenario for a map");
  const auto arguments = std::make_shared<ScenarioArguments>();
  arguments->map.add_to(scenario);
  arguments->moves.add_to(scenario);
  add_count(scenario, "--buckets", arguments->buckets,
            "Number of buckets, beginning with the shortest paths; each bucket covers path lengths "
            "in a range of 4 cells (default: all buckets of the map)");
  add_count(scenario, "--per-bucket", arguments->per_bucket,
            "Number of queries per bucket (default 10)");
  add_count(scenario, "--seed", arguments->seed, "Seed of the random queries (default 1)");
  add_format(scenario, arguments->format);
  arguments->output.add_to(scenario, {".scen"}, "Write the scenario; without -o it is printed");
  scenario.footer(kExamples);
  return {scenario, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
