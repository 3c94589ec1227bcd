#pragma once

// When a robot covers what: for pictures and films.

#include "wend/base/compiler.hpp"
#include "wend/cover/plan_coverage.hpp"
#include "wend/map/grid.hpp"

namespace wend {

/// For each cell how far the robot has driven, in metres, when its tool begins the line of the path that first covers it;
/// infinite for cells that are not wanted or not covered by the path. `tool_width` as in CoverageOptions. O(cells that the tool passes).
WEND_API Grid<double> coverage_times(const Coverage& coverage, const FreeSpace& space,
                                     double tool_width);

}  // namespace wend
