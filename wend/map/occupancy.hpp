#pragma once

// Occupancy grids, costmaps and speed masks as maps: what the bytes of ROS mean. A value in between makes a cell
// dearer; it is stored as a multiplier, the cost of a unit of length.
//
//   bytes                    blocked                free, and its multiplier                     unknown
//   nav_msgs/OccupancyGrid   occupied_from to 100   v below that: 1 + cost_factor v / 100        all others
//   costmap_2d               253, 254               v up to 252: 1 + cost_factor v / 252         255
//   the same, uninflated     254                    v up to 252 the same, 253 like 252           255
//   speed mask               none                   0: 1; v up to 100: top speed / its limit     all others
//
// Values are row by row; the first is that of cell (0, 0). In a grid of ROS that is the lower left cell, so its
// frame has y_up. A free space rounds multipliers to 1/256 (cost_map.hpp).
//
//   const std::vector<std::uint8_t> costs{0, 126, 254, 0, 252, 255};
//   const wend::Frame frame{.resolution = 0.05, .y_up = true, .metric = true};
//   const auto map = wend::map_from_costmap(costs, 3, 2, frame);
//   if (!map) return report(map.error().message);

#include <cstdint>
#include <optional>
#include <span>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/map/value_edit.hpp"

namespace wend {

/// How to read a nav_msgs/OccupancyGrid.
struct OccupancyScale {
  int occupied_from = 65;  // the least occupied value, 1 to 100
  double cost_factor = 0;  // what a value of 100 would add to a multiplier of 1, in 0..1e6
};

/// How to read a costmap of costmap_2d.
struct CostmapScale {
  double cost_factor = 4;  // what the value 252 adds to a multiplier of 1, in 0..1e6
  bool inscribed_blocked =
      true;  // is 253, within the inscribed radius of an obstacle, blocked? If not, the
             // robot to plan with is the real one, not a point

  friend bool operator==(const CostmapScale&, const CostmapScale&) = default;
};

/// How to read a speed mask. The value v of 1 to 100 limits the speed to base + multiplier v. A limit that is
/// not above 0, or not below the top speed, is none.
struct SpeedScale {
  double base = 0;        // finite
  double multiplier = 1;  // finite
  std::optional<double> top_speed =
      {};  // m/s, finite and above 0: limits are in m/s; nothing: in percent of the top speed
};

/// The map of an occupancy grid. Inflated cells of a costmap that was published as a grid have values below
/// 100: read such a grid with `occupied_from` 99 or 100 and a factor. Fails with invalid_map if the number of
/// values is not `width` * `height` or if the frame is invalid, and with invalid_option if the scale is. O(cells).
WEND_API Expected<GridMap, Error> map_from_occupancy(std::span<const std::int8_t> values, int width,
                                                     int height, const Frame& frame,
                                                     const OccupancyScale& scale = {});

/// The map of a costmap. Obstacles in it have grown by the robot's radius already (253), so the robot to plan
/// with is a point, unless the scale says that 253 is free. Fails as map_from_occupancy() does. O(cells).
WEND_API Expected<GridMap, Error> map_from_costmap(std::span<const std::uint8_t> costs, int width,
                                                   int height, const Frame& frame,
                                                   const CostmapScale& scale = {});

/// What a byte of a costmap says of its cell, see edit_between(). For a valid scale. O(1).
WEND_API CellMeaning meaning_of_cost(std::uint8_t cost, const CostmapScale& scale = {});

/// The map of a speed mask, to be laid over another map by masked(). The cost of a cell is then the time that it
/// takes. Fails as map_from_occupancy() does. O(cells).
WEND_API Expected<GridMap, Error> map_from_speed_mask(std::span<const std::int8_t> values,
                                                      int width, int height, const Frame& frame,
                                                      const SpeedScale& scale = {});

}  // namespace wend
