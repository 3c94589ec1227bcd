#pragma once

// Coverages as text and as JSON:
//
//   {"schema": 1, "covered_share": 0.999, "length_m", "lower_bound_m", "turns", "strokes", "tool_width_m", "area_m2",
//    "covered_m2", "missed": [{"cell": [x,y], "at_m": [x,y], "cells", "area_m2", "reachable", "widest_radius_m"}, ...],
//    "waypoints": [[x,y], ...], "waypoints_m": [[x,y], ...]}
//
// "area_m2" is what the tool can reach. "missed" are the largest places that were not covered; "reachable": the tool gets
// there, and left it out for the share that was asked for. The radius of the widest robot that gets there is null if not even a
// point does. "waypoints" are in grid coordinates.

#include <span>
#include <string>

#include "wend/cover/plan_coverage.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/session/units.hpp"

namespace wend {

/// A line for each thing.
std::string coverage_text(const Coverage& coverage, std::span<const MissedPlace> missed,
                          const Units& units);

/// One line with its line end. The tool's width is in metres.
std::string coverage_json(const Coverage& coverage, std::span<const MissedPlace> missed,
                          const Frame& frame, double tool_width);

}  // namespace wend
