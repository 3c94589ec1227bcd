#pragma once

// Analyses of a map for programs: a cost-to-go field with paths from it, and why there is no path.

#include <optional>
#include <string>
#include <vector>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/no_drive.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/report/plan_report.hpp"

namespace wend {

struct FieldStart {
  Cell start;
  PlanResult result;  // its metrics and its time mean nothing: no search is made for a start
};

struct FieldReport {
  std::vector<Cell> goals;
  Status status = Status::found;  // why there is no field
  std::string reason;             // the same for people
  SearchMetrics metrics;          // of computing the field
  WorkTimes times{};              // no planner and no index
  std::vector<FieldStart> starts;
};

/// {"schema", "goals", "status", "metrics", "times", "starts": [{"start", "status", "cost", "length_cells",
/// "length_m", "path", "path_m"}], "grid": {"width", "height", "costs", "policy"}}. The grid is
/// there where a field is given: a list for every row, row 0 first; null where there is no path,
/// and, in the policy, in a goal. Moves have the names of directions on a page ("up_left"). One
/// line.
std::string field_json(const FieldReport& report, const Frame& frame, const CostToGo* grid);

/// x,y,cost,move for every cell; cost and move are empty where there is no path, the move in a
/// goal.
std::string field_csv(const CostToGo& field, const Frame& frame);

/// Explains why there is no path:
///
///   {"schema": 1, "status": "unreachable", "start_region": 57, "goal_region": 12,
///    "widest": {"radius_cells": 3.5, "radius_m": 0.18, "narrowest": [64.5,82.5],
///               "narrowest_m": [3.2,4.1]},
///    "ways": [{"unknown_free": false, "squeeze": false, "smaller_robot": true, "widest": {...}}]}
///
/// `narrowest` is in grid coordinates. An infinite radius is null, and so is `widest` where not even a
/// point gets through; the metres are null where the map has none. `status` is `found` if there is a path
/// after all. One line with its line end.
std::string no_path_json(const NoPath& why, const Frame& frame);

/// Explains why there is no drive:
///
///   {"schema": 1, "status": "unreachable", "reason": "...", "widest": {...} or null,
///    "inscribed_radius_cells": 3.5, "footprint_scale": 0.8, "turning_radius_cells": 7.5, "turning_radius_m": 0.38,
///    "reverse_helps": true, "expanded": 4711}
///
/// `widest` is as in no_path_json(). What would not help, or does not apply, is null; the metres are null where the map
/// has none. `reason` is null if there is a drive after all. One line with its line end.
std::string no_drive_json(const NoDrive& why, const FreeSpace& space);

}  // namespace wend
