#pragma once

// Drives through unknown land, of one or more planners, for people and for programs.
//
//   {"schema": 1, "start": [x,y], "goal": [x,y], "sensor_range_cells": 100, "drives": [
//    {"planner": "replanner", "status": "found", "reason": "", "driven_cells", "driven_m", "cost", "replans",
//     "cells_seen", "expanded", "first_us", "planning_us", "worst_us", "path": [[x,y], ...]}]}
//
// "cost" is that of what was driven, on the true map. "first_us" is the time of the first plan, "planning_us" of all
// of them, "worst_us" of the longest but the first.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "wend/explore/explorer.hpp"
#include "wend/geometry/frame.hpp"

namespace wend {

/// The drive of one planner.
struct ExplorationRow {
  std::string planner;  // as it was asked for
  Status status = Status::found;
  std::string reason;  // if it is not found
  std::vector<Cell> driven;
  double cost = 0;  // of what was driven
  ExplorationTotals totals;
};

/// What was asked.
struct ExplorationReport {
  Cell start;
  Cell goal;
  double sensor_range = 0;  // cells
  std::vector<ExplorationRow> rows;
};

/// A row for each planner. `metric`: lengths in metres, else in cells. Columns for which there is no room in that width
/// follow below.
std::string exploration_table(const ExplorationReport& report, const Frame& frame, bool metric,
                              std::size_t width = 80);

/// One line with its line end.
std::string exploration_json(const ExplorationReport& report, const Frame& frame);

/// A line for each planner, after one with the names of the columns, those of the JSON without the path.
std::string exploration_csv(const ExplorationReport& report, const Frame& frame);

}  // namespace wend
