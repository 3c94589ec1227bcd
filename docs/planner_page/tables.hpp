#pragma once

// Tables of what was measured.

#include <span>
#include <string>

#include "docs/planner_page/measured_family.hpp"

namespace wend::planner_page {

/// A row a planner, the best of each column in bold.
std::string family_table(const MeasuredFamily& family);

/// A row a planner on queries without a path.
std::string no_path_table(const MeasuredFamily& family);

/// A row a map and a column a planner: times over that of astar, the fastest in bold.
std::string overview_table(std::span<const MeasuredFamily> families);

/// On how many maps each planner was the best.
std::string wins_table(std::span<const MeasuredFamily> families);

/// The planner with the smallest of such numbers, of those that qualify; null if none does.
template <class Number, class Qualifies>
const MeasuredPlanner* least(const MeasuredFamily& family, Number&& number, Qualifies&& qualifies) {
  const MeasuredPlanner* best = nullptr;
  for (const MeasuredPlanner& planner : family.planners) {
    if (!qualifies(planner)) continue;
    if (best == nullptr || number(planner) < number(*best)) best = &planner;
  }
  return best;
}

}  // namespace wend::planner_page
