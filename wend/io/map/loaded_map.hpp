#pragma once

// LoadedMap: a map, the format that it came in, and what was odd in the file.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wend/map/grid_map.hpp"

namespace wend {

enum class MapFormat { ros_yaml, moving_ai, text_grid, image };

/// "ROS map.yaml", "MovingAI", "text grid", "image"
std::string_view to_string(MapFormat format);

struct LoadedMap {
  GridMap map;
  MapFormat format;
  std::vector<std::string> notes;                 // what was odd in the file, and how it was read
  std::vector<std::filesystem::path> files = {};  // read for it: the map, and a map.yaml's image
};

}  // namespace wend
