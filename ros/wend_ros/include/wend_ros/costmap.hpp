#pragma once

// Costmaps of the navigation stack as maps: 255 is unknown, 253 and 254 are where a robot's centre may
// not be (the costmap has grown obstacles by the robot's radius already), and lower costs are rough
// ground: 252 costs five times as much.

#include <cstdint>
#include <span>

#include "wend/map/grid_map.hpp"

namespace wend_ros {

/// Row 0 is the southern one. As many costs as cells, at least one; in a frame that is not turned.
wend::GridMap map_from_costs(std::span<const std::uint8_t> costs, int width, int height,
                             double resolution, wend::MapPoint origin);

}  // namespace wend_ros
