#pragma once

// What keeping away from obstacles gives and costs: clearance against length.

#include <string>
#include <vector>

#include "docs/planner_page/generated_families.hpp"

namespace wend::planner_page {

/// Medians over the queries.
struct ClearanceCostRow {
  double clearance_distance = 0;  // metres
  double longer = 1;              // the length over that without keeping away
  double clearance = 0;           // metres, the mean along the path
  double least_clearance = 0;     // metres, the smallest along the path
  double expanded = 0;
  double us = 0;
};

struct ClearanceCostStudy {
  std::string about;
  std::vector<ClearanceCostRow> rows;  // the first does not keep away
};

/// astar in the office, for several distances.
ClearanceCostStudy study_clearance_distance(Effort effort);

std::string clearance_distance_table(const ClearanceCostStudy& study);

}  // namespace wend::planner_page
