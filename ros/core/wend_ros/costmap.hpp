#pragma once

// Costmaps of the navigation stack as maps: 255 is unknown, 253 and 254 are where a robot's centre may
// not be (the costmap has grown obstacles by the robot's radius already), and a lower cost v is rough
// ground: it costs 1 + cost_factor v / 252 times its length.

#include <cstdint>
#include <span>

#include "wend/map/grid_map.hpp"

namespace wend_ros {

/// Row 0 is the southernmost row; the frame is not rotated. Fails as wend::map_from_costmap() does.
wend::Expected<wend::GridMap, wend::Error> map_from_costs(std::span<const std::uint8_t> costs,
                                                          int width, int height, double resolution,
                                                          wend::MapPoint origin,
                                                          double cost_factor = 4);

}  // namespace wend_ros
