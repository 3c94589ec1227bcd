#pragma once

// Maps as nav_msgs/OccupancyGrid and back, and updates of them, map_msgs/OccupancyGridUpdate; occupancy.hpp says
// what the values mean. Row 0 is at the bottom, as in ROS maps; maps with y down are turned over, so that they
// lie in rviz as they are drawn.

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>

#include <string>

#include "wend/base/error.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/grid_map.hpp"
#include "wend_ros/occupancy.hpp"

namespace wend_ros {

/// How such a message's grid lies.
nav_msgs::MapMetaData information_of(const wend::GridMap& map);

nav_msgs::OccupancyGrid to_message(const wend::GridMap& map, const std::string& frame_id);

/// The values of a box of cells (not empty) of a map with y up.
map_msgs::OccupancyGridUpdate update_message(const wend::GridMap& map, const wend::CellBox& box,
                                             const std::string& frame_id);

/// Where a message's grid lies. Fails with invalid_map for an origin that pose_from() refuses.
wend::Expected<OccupancyLayout, wend::Error> layout_of(const nav_msgs::OccupancyGrid& message);

/// A view: the message must outlive it.
OccupancyUpdate update_of(const map_msgs::OccupancyGridUpdate& message);

/// Why a message is no map, invalid_map: "resolution 0", "12 cells, 20 x 10 expected".
wend::Expected<wend::GridMap, wend::Error> map_from(const nav_msgs::OccupancyGrid& message,
                                                    const MapReading& reading);

}  // namespace wend_ros
