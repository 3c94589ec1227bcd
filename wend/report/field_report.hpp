#pragma once

// A cost-to-go field, and paths taken from it, as JSON and CSV.

#include <optional>
#include <string>
#include <vector>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/report/plan_result.hpp"

namespace wend {

struct FieldStart {
  Cell start;
  PlanResult result;  // its metrics and its time mean nothing: no search is made for a start
};

struct FieldReport {
  std::vector<Cell> goals;
  Status status = Status::found;  // why there is no field
  std::string reason;             // the same for people
  SearchMetrics metrics;          // of making it
  WorkTimes times{};              // no planner and no index
  std::vector<FieldStart> starts;
};

/// {"schema", "goals", "status", "metrics", "times", "starts": [{"start", "status", "cost", "length_cells",
/// "length_m", "path", "path_m"}], "grid": {"width", "height", "costs", "policy"}}. The grid is
/// there where a field is given: a list for every row, row 0 first; null where there is no path,
/// and, in the policy, in a goal. Moves have the names of the directions as drawn ("up_left"). One
/// line.
std::string field_json(const FieldReport& report, const Frame& frame, const CostToGo* grid);

/// x,y,cost,move for every cell; cost and move are empty where there is no path, the move in a
/// goal.
std::string field_csv(const CostToGo& field);

}  // namespace wend
