#pragma once

// The maps that planners are compared on, each with its queries and its planners.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/comparison/random_queries.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/io/file_error.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::planner_page {

/// full: what docs/planners.md is written with. quick: small maps and three queries each, to see
/// that the page comes out right.
enum class Effort { quick, full };

/// A planner with its options.
struct Configuration {
  std::string name;  // the same on every map: "astar:weight=2"
  PlannerSpec spec;  // as it plans on this map: "astar:weight=2,connectivity=4"
};

struct BenchmarkMap {
  std::string title;
  std::string about;
  FreeSpace space;
  std::vector<CellPair> queries;
  std::vector<Configuration> planners;  // astar is the first
};

/// The map of that generator, which must be able to make it.
GridMap generated_map(std::string_view kind, int width, int height, std::uint64_t seed,
                      const OptionValues& options = {});

/// Maps of our own generators: uniform terrain and 8 neighbours, then 4 neighbours, then terrain.
std::vector<BenchmarkMap> generated_maps(Effort effort);

/// MovingAI maps of a data folder, each with a sample of its scenario. An error names the file that
/// could not be read.
Expected<std::vector<BenchmarkMap>, Error> movingai_maps(const std::filesystem::path& folder);

}  // namespace wend::planner_page
