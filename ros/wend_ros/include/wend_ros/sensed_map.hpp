#pragma once

// SensedMap: what a robot knows of a map that it discovers with a laser scanner that looks all around. Knows
// no ROS.
//
//   auto map = wend_ros::SensedMap::make(truth);
//   const wend::CellBox changed = map->look(robot, 5);

#include <optional>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/map/grid_map.hpp"

namespace wend_ros {

/// The cells that a laser scanner sees from a point in grid coordinates: up to the first occupied cell in each
/// direction, or `range` cells (> 0). Rays are so dense that their ends lie at most half a cell apart. Some cells occur
/// several times. None from outside of the map. O(range^2).
std::vector<wend::Cell> seen_cells(const wend::GridMap& map, wend::Point from, double range);

class SensedMap {
 public:
  /// The robot first knows what `known` says, or nothing. Fails with invalid_map if the two maps differ in
  /// size or frame.
  static wend::Expected<SensedMap, wend::Error> make(wend::GridMap truth,
                                                     std::optional<wend::GridMap> known = {});

  const wend::GridMap& truth() const { return truth_; }
  const wend::GridMap& known() const { return known_; }

  /// The robot looks around from a place, `range` metres far. Returns the least box of the cells that it
  /// knows otherwise than before.
  wend::CellBox look(wend::MapPoint from, double range);

 private:
  SensedMap(wend::GridMap truth, wend::GridMap known);

  wend::GridMap truth_;
  wend::GridMap known_;
};

}  // namespace wend_ros
