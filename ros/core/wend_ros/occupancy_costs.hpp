// SPDX-License-Identifier: Apache-2.0
#pragma once

// OccupancyCosts: the costs of a costmap from the map messages so far: nav_msgs/OccupancyGrid, and the
// map_msgs/OccupancyGridUpdate after it. Knows no ROS.
//
//   if (const auto taken = map.take(layout, message.data); !taken) return warn(taken.error().message);
//   planner.costmap().read(map.layout(), map.costs());
//
// A value of -1 is unknown (cost 255), from `occupied_from` on an obstacle (254), and a lower one 2.52 times its value:
// the rougher the higher, if the planner counts costs.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend_nav2/costmap_copy.hpp"
#include "wend_ros/occupancy.hpp"

namespace wend_ros {

class OccupancyCosts {
 public:
  /// Without a map. `occupied_from`: 1 to 100.
  explicit OccupancyCosts(int occupied_from = 65) : occupied_from_(occupied_from) {}

  /// Replaces the map. If the values are not a map, or its origin is turned, fails with invalid_map and has no map from
  /// then on. O(cells).
  wend::Expected<void, wend::Error> take(const OccupancyLayout& layout,
                                         std::span<const std::int8_t> values);

  /// Changes some cells. If there is no map, or the update does not fit it, fails with invalid_map and changes nothing.
  /// O(values).
  wend::Expected<void, wend::Error> take(const OccupancyUpdate& update);

  /// Has no map from then on.
  void clear() { costs_.clear(); }

  bool empty() const { return costs_.empty(); }
  const wend_nav2::CostmapLayout& layout() const { return layout_; }
  std::span<const std::uint8_t> costs() const { return costs_; }

 private:
  std::uint8_t cost_of(std::int8_t value) const;

  int occupied_from_;
  OccupancyLayout map_;
  wend_nav2::CostmapLayout layout_;
  std::vector<std::uint8_t> costs_;  // empty without a map
};

}  // namespace wend_ros
