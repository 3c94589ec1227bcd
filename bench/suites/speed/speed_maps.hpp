#pragma once

// The maps of the suite speed: those of a folder, or maps that are made from seeds, which everybody has.

#include <filesystem>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/map/grid_map.hpp"

namespace wend::bench {

struct SpeedMap {
  std::string name;
  GridMap map;
  std::vector<ScenarioQuery> queries;  // at least one
};

/// The maps of a folder with MovingAI scenarios. An error names the file and what is wrong with it.
Expected<std::vector<SpeedMap>, Error> maps_of_folder(const std::filesystem::path& folder);

/// Rooms, an office and a maze of some 512 x 512 cells and noise of 256 x 256, the same everywhere.
std::vector<SpeedMap> generated_maps();

}  // namespace wend::bench
