#pragma once

// MeasuredFamily: what the planners made of a family's queries.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "docs/planner_page/family.hpp"
#include "docs/planner_page/generated_families.hpp"
#include "wend/base/thread_time.hpp"

namespace wend::planner_page {

/// Statistics over the queries that every planner of the family solved, or over all of them if no
/// planner solved any. NaN where there is no path to speak of.
struct MeasuredPlanner {
  std::string role;     // as in Configuration
  std::string planner;  // as it is typed
  std::size_t solved = 0;
  double cost = 0;             // over the cheapest that any planner found: the median,
  double worst_cost = 0;       // and the greatest
  double expanded = 0;         // median
  double us = 0;               // median time
  double us_of_astar = 0;      // the median time over that of astar
  double clearance = 0;        // median of the smallest, in cells
  double ns_an_expansion = 0;  // all time over all expansions

  bool always_cheapest() const;
};

struct MeasuredFamily {
  std::string title;
  std::string about;
  bool is_maze = false;
  bool uniform_terrain = true;
  bool eight_neighbours = true;
  std::size_t queries = 0;
  std::size_t solved_by_all = 0;
  std::vector<MeasuredPlanner> planners;

  /// The planner of that role, or null.
  const MeasuredPlanner* find(std::string_view role) const;
};

/// How often each query is asked; the quickest answer counts.
RepetitionRule repetition(Effort effort);

MeasuredFamily measure_planners(const Family& family, Effort effort);

}  // namespace wend::planner_page
