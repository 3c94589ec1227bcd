#pragma once

// What the planners made of the queries of each benchmark map, measured and as tables.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/comparison/timed_planner.hpp"
#include "docs/planner_page/benchmark_maps.hpp"

namespace wend::planner_page {

/// Over the queries that every planner of the map solved.
struct MeasuredPlanner {
  std::string name;       // as in Configuration
  double cost = 0;        // over the cheapest that any planner found: the median,
  double worst_cost = 0;  // and the greatest
  double expanded = 0;    // median
  double us = 0;          // median
};

struct MeasuredMap {
  std::string title;
  std::string about;
  int width = 0;
  int height = 0;
  std::size_t passable = 0;  // cells
  std::size_t queries = 0;
  std::size_t solved_by_all = 0;
  std::vector<MeasuredPlanner> planners;

  /// The planner of that name, or null.
  const MeasuredPlanner* find(std::string_view name) const;
};

/// How often each query is repeated; the fastest answer counts.
RepetitionRule repetition(Effort effort);

MeasuredMap measure_planners(const BenchmarkMap& map, Effort effort);

/// What the maps are.
std::string map_table(std::span<const MeasuredMap> maps);

/// A row a map and a column a planner, the least of each row in bold: the time over that of astar.
std::string time_table(std::span<const MeasuredMap> maps);

/// The same of expanded cells.
std::string expanded_table(std::span<const MeasuredMap> maps);

/// The path cost over the cheapest, of the planners that did not always find a cheapest path.
std::string cost_table(std::span<const MeasuredMap> maps);

/// "1.000" for 3 decimals; bold if it is the best.
std::string decimal(double value, int decimals, bool best = false);

}  // namespace wend::planner_page
