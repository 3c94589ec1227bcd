#pragma once

// SpaceSurvey: statistics of the cells where one robot may be, without a FreeSpace: in the memory of a
// band of rows, regardless of the size of the map.

#include <cstddef>

#include "wend/base/compiler.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

struct SpaceSurvey {
  std::size_t passable = 0;
  std::size_t near_obstacles = 0;     // passable cells that cost more because of the clearance cost
  std::size_t components = 0;         // components of the passable cells, joined by edges
  std::size_t largest_component = 0;  // cells
  double least_terrain = 1;           // of the map, in passable cells
  double mean_terrain = 1;
  double greatest_terrain = 1;

  friend bool operator==(const SpaceSurvey&, const SpaceSurvey&) = default;
};

/// The same numbers as from make_free_space(map, options), which must not fail for the robot; fails if a cell
/// costs too much, as that does. O(cells).
WEND_API Expected<SpaceSurvey, Error> survey(const GridMap& map, const FreeSpaceOptions& options);

/// The memory that survey() needs in addition to the map, in bytes.
WEND_API double survey_bytes(const GridMap& map, const FreeSpaceOptions& options);

/// The same, computed in bands of at least `rows` rows and at least the robot's reach.
Expected<SpaceSurvey, Error> survey_in_bands(const GridMap& map, const FreeSpaceOptions& options,
                                             int rows);

}  // namespace wend
