#pragma once

// Answers to many queries, a row each, in the order in which they were asked.
//
//   line,start,goal,status,reason,cost,length_cells,length_m,expanded,search_us,start_shift_m,goal_shift_m
//   2,"1,1","15,9",found,,181.9,181.9,9.1,412,35.2,0.025,0.025
//   3,"1,1","0,0",goal_blocked,"the goal (0,0) m, ... is blocked: ...",,,,0,1.1,,
//
// The shifts say how far the path's ends are from what was asked; metres are cells on maps in cells.
//
// In JSON, one line:
//
//   {"schema": 1, "planner": "astar", "answers": [{"line": 2, "start": "1,1", "goal": "15,9",
//    "status": "found", "reason": "", "cost": 181.9, "length_cells": ..., "length_m": ..., "path":
//    [[x,y],...], "path_m": [[x,y],...], "start_shift": {"cells", "m", "degrees"}, "goal_shift": ...,
//    "metrics": {"expanded", "generated",
//    "max_frontier"}, "search_us": 35.2}, ...]}
//
// with "lead_out" and "remaining" where plan_json() has them, and "steps", "headings", "moves" and "yaw" for a car, as in plan_json().

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "wend/geometry/frame.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend {

/// The status of a row that is not a query: the reason says what is wrong with it.
inline constexpr std::string_view kInvalidQuery = "invalid_query";

struct QueryAnswer {
  std::size_t line = 0;  // of the query in its file
  std::string start;     // as written there
  std::string goal;
  std::string status;  // a name of the enum Status, or kInvalidQuery
  std::string reason;  // of a failure; else what was changed in the query, if anything
  Plan plan{};         // of a failure: its metrics
  double seconds = 0;  // CPU time of the search
  std::optional<LeadOut>
      lead_out{};  // how the path begins, if it leads out of what blocks the start
  std::optional<double> remaining{};  // metres to the nearest goal, if it could not be reached

  bool found() const { return !plan.path.empty(); }
};

std::string query_answers_csv(std::span<const QueryAnswer> answers, const Frame& frame);

std::string query_answers_json(std::string_view planner, std::span<const QueryAnswer> answers,
                               const Frame& frame, const Capabilities& capabilities);

/// A table for people, then the number of answers with each status.
std::string query_answers_text(std::span<const QueryAnswer> answers, const Frame& frame);

}  // namespace wend
