#pragma once

// How the car's estimates do on yards of different kinds.

#include <string>
#include <vector>

#include "docs/planner_page/generated_families.hpp"

namespace wend::planner_page {

/// Medians over the drives on a yard.
struct DriveRow {
  std::string planner;    // as it is typed
  double cost = 1;        // fuel over the least fuel: the median,
  double worst_cost = 1;  // and the greatest
  double expanded = 0;
  double us = 0;
};

struct DriveYard {
  std::string title;
  std::size_t drives = 0;
  std::vector<DriveRow> rows;

  const DriveRow& fastest_optimal() const;
};

struct DriveStudy {
  std::string about;
  std::vector<DriveYard> yards;
};

/// `car` with each of its heuristics, and with a weight.
DriveStudy study_drives(Effort effort);

std::string drive_tables(const DriveStudy& study);

/// Which estimate to choose, by the numbers.
std::string drive_findings(const DriveStudy& study);

}  // namespace wend::planner_page
