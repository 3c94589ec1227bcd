#pragma once

// A plan, or why there is none, as JSON:
//
//   {"planner": "astar", "status": "found", "cost": 2.41, "bound": 1,
//    "length_cells": 2.41, "length_m": 0.12, "path": [[1,1],[2,2],[3,2]], "path_m":
//    [[0.07,0.07],...], "metrics": {"expanded": 3, "generated": 9, "max_frontier": 6,
//    "time_us": 4.2}}
//
// `path` counts in cells, `path_m` are their centres in the map's frame. `bound` is the factor by
// which the cost may exceed the cheapest one, null where nothing is promised. On failure `status`
// is the reason by name and `reason` says it in words; `path` and `path_m` are empty, `cost` and
// the lengths null. Layers, where they are given, follow as "layers": {"g": [[0,1,...],...]}, a
// list for every row, row 0 first: numbers, or names of directions as drawn ("up_left"); null where
// there is nothing.

#include <span>
#include <string>

#include "wend/geometry/frame.hpp"
#include "wend/planner/layer.hpp"
#include "wend/report/plan_result.hpp"

namespace wend {

/// One line with its line end.
std::string plan_json(const PlanResult& result, const Frame& frame,
                      std::span<const Layer> layers = {});

}  // namespace wend
