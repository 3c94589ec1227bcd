#pragma once

// Strips along walls: the pieces of the contour of the robot's places where its tool covers something that is left.
// What lies next to an obstacle can only be covered from there, so these strips come before the swaths.

#include <vector>

#include "wend/cover/coverage_area.hpp"

namespace wend {

/// Strokes along the contours of the reachable cells, of which each covers at least `least` cells that are left, and
/// is left out where it covers none. Covers them in the area. O(cells + contour times cells that the tool covers).
std::vector<Stroke> wall_strips(CoverageArea& area, double least);

}  // namespace wend
