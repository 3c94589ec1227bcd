#pragma once

// MapInfo: the content of a map file, and what it means for one robot.

#include <cstddef>
#include <string>
#include <vector>

#include "wend/io/map/map_format.hpp"
#include "wend/robot/space_survey.hpp"

namespace wend {

struct MapInfo {
  std::string file;
  MapFormat format;
  int width = 0;
  int height = 0;
  std::size_t free = 0;
  std::size_t occupied = 0;
  std::size_t unknown = 0;
  Footprint footprint;  // metres (cells, where the map has no resolution)
  OutsidePolicy outside = OutsidePolicy::free;
  double clearance_distance = 0;  // same unit as the footprint
  SpaceSurvey space;              // the cells where the robot may be
  Frame frame;
  std::vector<std::string> notes;  // what was unusual in the file
};

/// Needs little more memory than the map itself.
Expected<MapInfo, Error> map_info(std::string file, const LoadedMap& loaded,
                                  const FreeSpaceOptions& robot);

/// One line with its line end.
std::string map_info_json(const MapInfo& info);

/// The same for people, a line for each value.
std::string map_info_text(const MapInfo& info);

}  // namespace wend
