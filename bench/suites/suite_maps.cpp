#include "bench/suites/suite_maps.hpp"

#include <fmt/format.h>

#include <utility>

#include "bench/suites/suite.hpp"
#include "wend/generate/generators.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend::bench {

std::filesystem::path data_folder() { return WEND_DATA; }

std::vector<NamedMap> loaded_maps(const std::vector<std::filesystem::path>& files) {
  std::vector<NamedMap> maps;
  for (const std::filesystem::path& file : files) {
    auto loaded = load_map(file);
    if (!loaded) {
      fmt::print(stderr, "{}: not measured: {}\n", file.string(), loaded.error().message);
      continue;
    }
    // A folder for each map is usual, with the same name for every file.
    const std::string stem = file.stem().string();
    const std::string name = stem == "map" ? file.parent_path().filename().string() : stem;
    maps.push_back({name, std::move(loaded->map)});
  }
  return maps;
}

GridMap generated_map(std::string_view kind, int width, int height, const OptionValues& options,
                      std::uint64_t seed) {
  return value_or_refuse(make_map(kind, width, height, seed, options));
}

GridMap in_metres(const GridMap& map, double resolution) {
  Frame frame = map.frame();
  frame.resolution = resolution;
  frame.metric = true;
  return *make_grid_map(map.occupied(), map.unknown(), frame, map.terrain());
}

}  // namespace wend::bench
