// SPDX-License-Identifier: Apache-2.0
#pragma once

// Costmaps drawn as text, for tests: '#' is lethal (254), 'i' inscribed (253), '?' unknown (255), a digit d costs
// 28 d, '.' is free. The first line is the top row.

#include <cstdint>
#include <string>
#include <vector>

#include "wend_nav2/costmap_copy.hpp"

namespace wend_nav2::test {

struct Costmap {
  CostmapLayout layout;
  std::vector<std::uint8_t> costs;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(layout.width) +
           static_cast<std::size_t>(x);
  }
  std::uint8_t& at(int x, int y) { return costs[index(x, y)]; }
  std::uint8_t at(int x, int y) const { return costs[index(x, y)]; }
};

inline std::uint8_t cost_of(char drawn) {
  switch (drawn) {
    case '#':
      return 254;
    case 'i':
      return 253;
    case '?':
      return 255;
    case '.':
      return 0;
    default:
      return static_cast<std::uint8_t>((drawn - '0') * 28);
  }
}

inline Costmap costmap_of(const std::vector<std::string>& rows, double resolution = 0.1) {
  Costmap map{.layout = {.width = static_cast<int>(rows.front().size()),
                         .height = static_cast<int>(rows.size()),
                         .resolution = resolution,
                         .origin = {0, 0},
                         .frame_id = "map"},
              .costs = {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char drawn : *row) map.costs.push_back(cost_of(drawn));
  }
  return map;
}

inline Costmap empty_costmap(int width, int height, double resolution = 0.1) {
  return costmap_of(std::vector<std::string>(static_cast<std::size_t>(height),
                                             std::string(static_cast<std::size_t>(width), '.')),
                    resolution);
}

/// The middle of a cell.
inline wend::MapPose middle_of(const Costmap& map, int x, int y, double heading = 0) {
  return {(x + 0.5) * map.layout.resolution, (y + 0.5) * map.layout.resolution, heading};
}

}  // namespace wend_nav2::test
