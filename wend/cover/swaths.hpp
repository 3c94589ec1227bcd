#pragma once

// Swaths: parallel strokes that cover a part of an area, each as far from the one before as leaves nothing between
// them, and no longer than what is left below it.

#include <optional>
#include <span>
#include <vector>

#include "wend/cover/coverage_area.hpp"

namespace wend {

struct SwathOptions {
  double overlap = 0;    // of neighbouring swaths, in cells
  double turn_cost = 0;  // of half a turn, in cells
  std::optional<double> angle =
      {};  // of the swaths, radians from +x; nothing: the cheapest one for each part
};

/// Swaths for the cells of a part that are left; covers them in the area. They may leave cells over. O(cells log cells)
/// for each of twelve angles.
std::vector<Stroke> swaths(CoverageArea& area, std::span<const Cell> part,
                           const SwathOptions& options);

}  // namespace wend
