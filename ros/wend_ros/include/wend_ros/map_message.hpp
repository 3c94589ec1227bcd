#pragma once

// Maps as nav_msgs/OccupancyGrid and back. A cell is -1 (unknown), 100 (occupied), or 0 to 99:
// free, and the rougher the higher: terrain 1 + 4 v / 100, as map.yaml's `mode: scale` has it.
// Row 0 is at the bottom, as in ROS maps; maps with y down are turned over, so that they lie in rviz
// as they are drawn.

#include <nav_msgs/OccupancyGrid.h>

#include <string>

#include "wend/base/error.hpp"
#include "wend/map/grid_map.hpp"

namespace wend_ros {

/// How such a message's grid lies.
nav_msgs::MapMetaData information_of(const wend::GridMap& map);

nav_msgs::OccupancyGrid to_message(const wend::GridMap& map, const std::string& frame_id);

struct MapReading {
  int occupied_from = 65;  // values of 1 to 99 that are obstacles; map_server's usual threshold
  bool rough = false;      // lower ones are rough ground, else free
};

/// Why a message is no map, invalid_map: "resolution 0", "12 cells, 20 x 10 expected".
wend::Expected<wend::GridMap, wend::Error> map_from(const nav_msgs::OccupancyGrid& message,
                                                    const MapReading& reading);

}  // namespace wend_ros
