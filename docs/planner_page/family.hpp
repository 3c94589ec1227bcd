#pragma once

// Family: a map of one character, with the queries and the planners that are measured on it.

#include <string>
#include <string_view>
#include <vector>

#include "bench/comparison/comparison_run.hpp"
#include "wend/map/free_space.hpp"
#include "wend/planner/planners.hpp"

namespace wend::planner_page {

/// A planner with its options, and what it is the same as on other maps.
struct Configuration {
  std::string role;  // "astar:weight=2"
  PlannerSpec spec;  // "astar:weight=2,connectivity=4"
};

struct Family {
  std::string title;  // "Maze"
  std::string about;  // sentences: what the map and the queries are
  FreeSpace space;
  std::vector<CellPair> queries;
  std::vector<Configuration> planners;
  bool is_maze = false;
};

/// Every registered planner that searches and finds a path whenever there is one, and variants of A*, each with
/// `option` (as "connectivity=4") besides; those that do not have it are left out.
std::vector<Configuration> configurations(std::string_view option = {});

/// Those that do not refuse the map.
std::vector<Configuration> those_that_take(const FreeSpace& space,
                                           std::vector<Configuration> configurations);

/// Every registered planner that searches, as it is without options.
std::vector<Configuration> all_planners();

}  // namespace wend::planner_page
