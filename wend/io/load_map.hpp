#pragma once

// Loading maps: one function for every format, told apart by name and content.
//
//   format        names                     y     units
//   ROS map       *.yaml *.yml (+ image)    up    metres
//   MovingAI      *.map                     down  cells
//   text grid     *.txt *.grid              down  cells
//   bare image    *.png *.pgm *.pbm *.ppm   down  cells, or metres where a resolution is given
//
// Every loader returns a map, or an error with file, line and what is wrong. Memory stays in
// proportion to the file.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

enum class MapFormat { ros_yaml, moving_ai, text_grid, image };

/// "ROS map.yaml", "MovingAI", "text grid", "image"
std::string_view to_string(MapFormat format);

struct LoadedMap {
  GridMap map;
  MapFormat format;
  std::vector<std::string> notes;  // what was odd in the file, and how it was read
};

struct LoadOptions {
  std::optional<double> resolution;  // metres a cell, > 0, for a bare image
  double scale_factor = 4;           // terrain of a `mode: scale` map: 1 + scale_factor * v / 100
};

Expected<LoadedMap, IoError> load_map(const std::filesystem::path& file,
                                      const LoadOptions& options = {});

}  // namespace wend
