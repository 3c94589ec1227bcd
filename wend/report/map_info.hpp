#pragma once

// MapInfo: what a map file holds, and what it is to one robot.

#include <cstddef>
#include <string>
#include <vector>

#include "wend/io/loaded_map.hpp"
#include "wend/map/free_space.hpp"

namespace wend {

struct MapInfo {
  std::string file;
  MapFormat format;
  int width = 0;
  int height = 0;
  std::size_t free = 0;
  std::size_t occupied = 0;
  std::size_t unknown = 0;
  double least_terrain = 1;  // of the cells where the robot may be
  double mean_terrain = 1;
  double greatest_terrain = 1;
  double robot_radius = 0;            // metres (cells, where the map has no resolution)
  std::size_t passable = 0;           // cells where the robot may be
  std::size_t components = 0;         // regions of them, joined by edges
  std::size_t largest_component = 0;  // cells
  Frame frame;
  std::vector<std::string> notes;  // what was odd in the file
};

MapInfo map_info(std::string file, const LoadedMap& loaded, const FreeSpace& space);

/// One line with its line end.
std::string map_info_json(const MapInfo& info);

/// The same for people, a line for each thing.
std::string map_info_text(const MapInfo& info);

}  // namespace wend
