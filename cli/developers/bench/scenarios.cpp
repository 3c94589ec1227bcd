#include "cli/developers/bench/scenarios.hpp"

#include <bit>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include "cli/arguments/input_files.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenario_files(const std::vector<std::string>& files_and_folders) {
  std::vector<fs::path> files;
  for (const std::string& name : files_and_folders) {
    std::error_code error;  // a missing file is not a folder
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    const std::vector<fs::path> inside = value_or_throw(scenarios_in(name));
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// FNV-1a over numbers.
class Fingerprint {
 public:
  void add(std::uint64_t number) { hash_ = (hash_ ^ number) * 0x100000001B3; }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

std::uint64_t fingerprint_of(const Scenario& scenario, const GridMap& map) {
  Fingerprint fingerprint;
  fingerprint.add(map_hash(make_free_space(map)->passable()));
  for (const ScenarioQuery& query : scenario.queries) {
    for (const Cell cell : {query.start, query.goal}) {
      fingerprint.add(static_cast<std::uint64_t>(cell.x));
      fingerprint.add(static_cast<std::uint64_t>(cell.y));
    }
    fingerprint.add(query.line);
    fingerprint.add(std::bit_cast<std::uint64_t>(query.length));
  }
  return fingerprint.value();
}

BenchScenario load_bench_scenario(const fs::path& file, const std::string& map_file,
                                  std::size_t sample) {
  Scenario scenario = value_or_throw(load_scenario(file));
  const fs::path map_path =
      map_file.empty() ? value_or_throw(scenario_map_path(scenario)) : fs::path(map_file);
  LoadedMap loaded = value_or_throw(load_map(map_path));
  complain_of_notes(map_path.string(), loaded);
  const auto fits = check_map_size(scenario, loaded.map.width(), loaded.map.height());
  if (!fits) throw InputError(fits.error().message);
  const std::uint64_t fingerprint = fingerprint_of(scenario, loaded.map);
  scenario.queries = evenly_sampled(scenario.queries, sample);
  return {std::move(scenario), map_path.stem().string(), std::move(loaded.map),
          std::move(loaded.files), fingerprint};
}

constexpr int kDecimals = 8;

/// The options of a planner with these moves.
OptionValues options_of(GridMoves moves) {
  OptionValues values;
  for (const auto& choice : choice_names(Connectivity{})) {
    if (choice.value == moves.connectivity) values.emplace_back("connectivity", choice.name);
  }
  for (const auto& choice : choice_names(CornerRule{})) {
    if (choice.value == moves.corner_rule) values.emplace_back("corner_rule", choice.name);
  }
  return values;
}

}  // namespace

std::vector<BenchScenario> load_scenarios(const std::vector<std::string>& files_and_folders,
                                          const std::string& map_file, std::size_t sample) {
  std::vector<BenchScenario> scenarios;
  for (const fs::path& file : scenario_files(files_and_folders)) {
    scenarios.push_back(load_bench_scenario(file, map_file, sample));
  }
  return scenarios;
}

void set_lengths(std::vector<ScenarioQuery>& queries, const FreeSpace& space, GridMoves moves) {
  const auto planner = make_planner("dijkstra", space, options_of(moves));
  if (!planner) throw InputError(planner.error().message);
  ProgressBar bar("lengths", queries.size());
  Plan plan;
  std::uint64_t done = 0;
  for (ScenarioQuery& query : queries) {
    const Status status = (*planner)->plan(Query::between(query.start, query.goal), plan);
    query.length = status == Status::found ? plan.cost : std::numeric_limits<double>::infinity();
    query.decimals = kDecimals;
    bar.update(++done);
  }
}

}  // namespace wend::cli
