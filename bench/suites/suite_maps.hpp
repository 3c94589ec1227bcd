#pragma once

// The maps that suites measure on.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/options.hpp"
#include "wend/map/grid_map.hpp"

namespace wend::bench {

struct NamedMap {
  std::string name;
  GridMap map;
};

/// The folder with real maps; empty where the build found none.
std::filesystem::path data_folder();

/// Loads maps; a line on stderr for each that cannot be loaded.
std::vector<NamedMap> loaded_maps(const std::vector<std::filesystem::path>& files);

/// A map of a generator. Throws Refused for what it does not take.
GridMap generated_map(std::string_view kind, int width, int height,
                      const OptionValues& options = {}, std::uint64_t seed = 7);

/// The same map with cells of this size, in metres.
GridMap in_metres(const GridMap& map, double resolution);

}  // namespace wend::bench
