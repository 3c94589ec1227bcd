#pragma once

// What `wend bench` runs planners on: scenarios, each with its map.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "wend/io/query/scenario.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

struct BenchScenario : Scenario {
  std::string map_name;  // of its file, without folder and extension
  GridMap map;
  std::vector<std::filesystem::path> map_files;  // read for it
  std::uint64_t fingerprint = 0;                 // of map and queries, whether sampled or not
};

/// The scenarios of files and of folders; `map_file` is the map of all scenarios, unless it is
/// empty. At most `sample` queries of each, evenly spread. Throws InputError.
std::vector<BenchScenario> load_scenarios(const std::vector<std::string>& files_and_folders,
                                          const std::string& map_file, std::size_t sample);

/// Sets the lengths of queries to what Dijkstra's algorithm finds: infinite where there is no path.
void set_lengths(std::vector<ScenarioQuery>& queries, const FreeSpace& space, GridMoves moves);

}  // namespace wend::cli
