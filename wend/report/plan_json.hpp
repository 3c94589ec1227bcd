#pragma once

// A plan, or why there is none, as JSON:
//
//   {"schema": 1, "planner": "astar", "status": "found", "cost": 2.41, "bound": 1,
//    "length_cells": 2.41, "length_m": 0.12, "path": [[1,1],[2,2],[3,2]], "path_m":
//    [[0.07,0.07],...], "metrics": {"expanded": 3, "generated": 9, "max_frontier": 6},
//    "times": {"load_us": 310.5, "free_space_us": 92.1, "planner_us": 3.6, "index_us": null,
//    "search_us": 4.2}}
//
// `times` are CPU time, see work_times.hpp; null is what there was not.
// `path` counts in cells, `path_m` are their centres in the map's frame. `bound` is the factor by
// which the cost may exceed the cheapest one, null where nothing is guaranteed. On failure `status`
// is the reason by name and `reason` says it in words; `path` and `path_m` are empty, `cost` and
// the lengths null.
//
// Of a path that was simplified, smoothed or resampled, "path_smoothed", "path_smoothed_m",
// "smoothing", "path_metrics" and "path_smoothed_metrics" follow: see path_report.hpp. `path` and the
// cost stay those of the plan. `path_smoothed` are waypoints in grid coordinates, in which the centre
// of cell (i,j) is (i+0.5, j+0.5).
//
// Of a car:
//
//   {"schema": 1, "planner": "car", "status": "found", "cost": 2.57, "length_cells": 2.57, "length_m": 0.12,
//    "steps": 2, "path": [[1,0],[2,1],[2,2]], "headings": ["E","S","S"], "moves":
//    ["FWD_RIGHT","FWD"], "path_m": [[0.05,0],...], "yaw": [0,1.57,1.57], "bound": 1,
//    "start_shift": {"cells": 0.5, "m": 0.025, "degrees": 4}, "goal_shift": {...},
//    "steps_in_reverse": 0, "turning_radius_cells": 1, "turning_radius_m": 0.05, "states": 1600,
//    "metrics": {...}, "times": {...}}
//
// `path` are then corners of the map, `headings` N, W, E or S as drawn (a pose that faces elsewhere
// has its angle instead, in radians from +x towards +y of the grid), `moves` and `steps` what joins
// them, one fewer. `path_m` are the same points in the map's frame and `yaw` the headings there,
// radians counter-clockwise from its +x. The shifts say how far the corners and headings are from
// what was asked, `states` in how many the car may be. On failure the lists are empty, `steps` and
// the shifts null.
//
// Layers, where they are given, follow as "layers": {"g": [[0,1,...],...]}, a
// list for every row, row 0 first: numbers, or names of directions as drawn ("up_left"); null where
// there is nothing.

#include <span>
#include <string>

#include "wend/analysis/layer.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/report/plan_result.hpp"

namespace wend {

/// One line with its line end.
std::string plan_json(const PlanResult& result, const Frame& frame,
                      std::span<const Layer> layers = {});

}  // namespace wend
