#pragma once

// Why there is no path, as JSON:
//
//   {"schema": 1, "status": "unreachable", "start_region": 57, "goal_region": 12,
//    "widest": {"radius_cells": 3.5, "radius_m": 0.18, "narrowest": [64.5,82.5],
//               "narrowest_m": [3.2,4.1]},
//    "ways": [{"unknown_free": false, "squeeze": false, "smaller_robot": true, "widest": {...}}]}
//
// `schema` grows when a key changes its name or meaning. `narrowest` is in grid coordinates. An infinite radius is null, and so is `widest` where not even
// a point gets through; the metres are null where the map has none. `status` is `found` if there is
// a path after all.

#include <string>

#include "wend/analysis/no_path.hpp"
#include "wend/geometry/frame.hpp"

namespace wend {

/// One line with its line end.
std::string no_path_json(const NoPath& why, const Frame& frame);

}  // namespace wend
