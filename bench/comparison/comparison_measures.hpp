#pragma once

// What planners are compared by.

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "bench/comparison/comparison.hpp"
#include "bench/measure/statistics.hpp"

namespace wend {

struct Measure {
  std::string_view key;     // as programs call it
  std::string_view title;   // as people do
  std::string_view unit{};  // empty for counts and ratios
  int decimals = 0;         // shown to people
  bool of_path = false;     // meaningless without a path
  bool of_cars = false;     // shown only for cars
  bool more_is_better = false;
  bool in_metres = false;  // `value` is in cells and must be multiplied by the resolution
  bool per_metre = false;  // `value` is in 1 / cells and must be divided by it
  double (*value)(const ComparedQuery&, const ComparisonRow&);

  /// Is its unit in metres, or in cells? Neither if the unit has no length.
  bool metric() const { return in_metres || per_metre; }
  bool of_cells() const { return unit == "cells" || unit == "1/cells"; }

  /// The value for one planner on one query. NaN if it has no meaning.
  double of(const Comparison& comparison, const ComparedQuery& query, std::size_t planner) const;
};

/// The measures that matter for the comparison, in display order.
std::vector<std::reference_wrapper<const Measure>> measures_of(const Comparison& comparison);

/// The measure with that key, which must exist.
const Measure& measure(std::string_view key);

/// The planners' names, from the first query.
std::vector<std::string> planners_of(const Comparison& comparison);

std::size_t solved_by(const Comparison& comparison, std::size_t planner);
std::size_t solved_by_all(const Comparison& comparison);

/// Statistics over the queries that every planner solved. `p99` is the 99th percentile; for a measure
/// whose larger values are better it is the 1st percentile.
Summary summary_of(const Comparison& comparison, const Measure& measure, std::size_t planner);

}  // namespace wend
