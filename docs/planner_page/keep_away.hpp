#pragma once

// What keeping away from obstacles gives and costs: clearance against length.

#include <string>
#include <vector>

#include "docs/planner_page/generated_families.hpp"

namespace wend::planner_page {

/// Medians over the queries.
struct KeepAwayRow {
  double keep_away = 0;        // metres
  double longer = 1;           // the length over that without keeping away
  double clearance = 0;        // metres, the mean along the path
  double least_clearance = 0;  // metres, the smallest along the path
  double expanded = 0;
  double us = 0;
};

struct KeepAwayStudy {
  std::string about;
  std::vector<KeepAwayRow> rows;  // the first does not keep away
};

/// astar in the office, for several distances.
KeepAwayStudy study_keep_away(Effort effort);

std::string keep_away_table(const KeepAwayStudy& study);

}  // namespace wend::planner_page
