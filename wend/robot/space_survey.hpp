#pragma once

// SpaceSurvey: what can be counted of the cells where one robot may be, without a FreeSpace: in the
// memory of a band of rows, however large the map is.

#include <cstddef>

#include "wend/map/grid_map.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

struct SpaceSurvey {
  std::size_t passable = 0;
  std::size_t near_obstacles = 0;     // of them: those that the clearance cost makes cost more
  std::size_t components = 0;         // components of them, joined by edges
  std::size_t largest_component = 0;  // cells
  double least_terrain = 1;           // of the map, in passable cells
  double mean_terrain = 1;
  double greatest_terrain = 1;

  friend bool operator==(const SpaceSurvey&, const SpaceSurvey&) = default;
};

/// As FreeSpace(map, options) has them. O(cells).
SpaceSurvey survey(const GridMap& map, const FreeSpaceOptions& options);

/// What it takes for that beside the map, in bytes.
double survey_bytes(const GridMap& map, const FreeSpaceOptions& options);

/// The same, computed in bands of at least `rows` rows and at least the robot's reach.
SpaceSurvey survey_in_bands(const GridMap& map, const FreeSpaceOptions& options, int rows);

}  // namespace wend
