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
  double least_terrain = 1;  // as the file says, of the cells where the robot may be
  double mean_terrain = 1;
  double greatest_terrain = 1;
  double robot_radius = 0;  // metres (cells, where the map has no resolution)
  OutsidePolicy outside = OutsidePolicy::free;
  double keep_away = 0;               // units as robot_radius
  std::size_t passable = 0;           // cells where the robot may be
  std::size_t near_obstacles = 0;     // of them: those that keep-away makes cost more
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
