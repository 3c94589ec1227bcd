#pragma once

// SensedMap: what a robot knows of a map that it discovers with a laser scanner that looks all around. Knows
// no ROS.
//
//   auto map = wend_ros::SensedMap::make(truth);
//   const wend::CellBox changed = map->look(robot, 5);

#include <optional>

#include "wend/base/error.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/obstacles.hpp"

namespace wend_ros {

class SensedMap {
 public:
  /// The robot first knows what `known` says, or nothing. Fails with invalid_map if the two maps differ in
  /// size or frame.
  static wend::Expected<SensedMap, wend::Error> make(wend::GridMap truth,
                                                     std::optional<wend::GridMap> known = {});

  const wend::GridMap& truth() const { return truth_.map(); }
  const wend::GridMap& known() const { return known_; }

  /// The robot looks around from a place, `range` metres far, as wend::append_visible_cells() sees; unknown
  /// cells of the true map hide nothing. Returns the least box of the cells that it knows otherwise than before.
  wend::CellBox look(wend::MapPoint from, double range);

 private:
  SensedMap(wend::GridMap truth, wend::GridMap known);

  wend::Obstacles truth_;
  wend::GridMap known_;
};

}  // namespace wend_ros
