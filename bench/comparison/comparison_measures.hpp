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
  bool in_metres = false;  // what `value` gives is in cells and to be multiplied by the resolution
  bool per_metre = false;  // it is in 1 / cells and to be divided by it
  double (*value)(const ComparedQuery&, const ComparisonRow&);

  /// Does it count in metres, or in cells? Neither of those without a length in their unit.
  bool metric() const { return in_metres || per_metre; }
  bool of_cells() const { return unit == "cells" || unit == "1/cells"; }

  /// Of one planner on one query. NaN if it has no meaning.
  double of(const Comparison& comparison, const ComparedQuery& query, std::size_t planner) const;
};

/// All that are of interest for what is compared, in the order in which people read them.
std::vector<std::reference_wrapper<const Measure>> measures_of(const Comparison& comparison);

/// The measure with that key, which must exist.
const Measure& measure(std::string_view key);

/// The planners' names, from the first query.
std::vector<std::string> planners_of(const Comparison& comparison);

std::size_t solved_by(const Comparison& comparison, std::size_t planner);
std::size_t solved_by_all(const Comparison& comparison);

/// Over the queries that every planner solved; `p99` is what 99 of 100 of them do no worse than: of a
/// measure of which more is better the 1st percentile.
Summary summary_of(const Comparison& comparison, const Measure& measure, std::size_t planner);

}  // namespace wend
