#include "wend/report/comparison_measures.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace wend {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

double cost_ratio(const ComparedQuery& query, const ComparisonRow& row) {
  double cheapest = row.cost;
  for (const ComparisonRow& other : query.rows) {
    if (other.found()) cheapest = std::min(cheapest, other.cost);
  }
  return cheapest > 0 ? row.cost / cheapest : 1;
}

double length(const ComparedQuery&, const ComparisonRow& row) { return row.length; }
double clearance(const ComparedQuery&, const ComparisonRow& row) { return row.smallest_clearance; }

constexpr std::array kMeasures{
    Measure{"cost", "cost", "", 2, true, false, false,
            [](const ComparedQuery&, const ComparisonRow& row) { return row.cost; }},
    Measure{"cost_ratio", "cost / least", "", 3, true, false, false, cost_ratio},
    Measure{"length_cells", "length", "cells", 2, true, false, false, length},
    Measure{"length_m", "length", "m", 2, true, false, true, length},
    Measure{"turning_degrees", "turning", "degrees", 0, true, false, false,
            [](const ComparedQuery&, const ComparisonRow& row) { return row.turning; }},
    Measure{"clearance_cells", "clearance", "cells", 2, true, true, false, clearance},
    Measure{"clearance_m", "clearance", "m", 2, true, true, true, clearance},
    Measure{"expanded", "expanded", "", 0, false, false, false,
            [](const ComparedQuery&, const ComparisonRow& row) {
              return static_cast<double>(row.expanded);
            }},
    Measure{"generated", "generated", "", 0, false, false, false,
            [](const ComparedQuery&, const ComparisonRow& row) {
              return static_cast<double>(row.generated);
            }},
    Measure{"max_frontier", "frontier", "", 0, false, false, false,
            [](const ComparedQuery&, const ComparisonRow& row) {
              return static_cast<double>(row.max_frontier);
            }},
    Measure{"time_us", "time", "us", 1, false, false, false,
            [](const ComparedQuery&, const ComparisonRow& row) { return row.seconds * 1e6; }}};

bool all_found(const ComparedQuery& query) {
  return std::all_of(query.rows.begin(), query.rows.end(),
                     [](const ComparisonRow& row) { return row.found(); });
}

/// Equal but for rounding: costs are sums.
bool equal(double a, double b) { return a == b || std::abs(a - b) <= 1e-9 * std::abs(a); }

}  // namespace

double Measure::of(const Comparison& comparison, const ComparedQuery& query,
                   std::size_t planner) const {
  const ComparisonRow& row = query.rows[planner];
  if (of_path && !row.found()) return kNothing;
  return value(query, row) * (in_metres ? comparison.frame.resolution : 1);
}

std::span<const Measure> measures() { return kMeasures; }

const Measure& measure(std::string_view key) {
  const auto* const place =
      std::find_if(kMeasures.begin(), kMeasures.end(),
                   [key](const Measure& measure) { return measure.key == key; });
  assert(place != kMeasures.end());
  return *place;
}

std::vector<std::string> planners_of(const Comparison& comparison) {
  std::vector<std::string> names;
  if (comparison.queries.empty()) return names;
  for (const ComparisonRow& row : comparison.queries.front().rows) names.push_back(row.planner);
  return names;
}

std::size_t solved_by(const Comparison& comparison, std::size_t planner) {
  const auto& queries = comparison.queries;
  return static_cast<std::size_t>(
      std::count_if(queries.begin(), queries.end(),
                    [planner](const ComparedQuery& query) { return query.rows[planner].found(); }));
}

std::size_t solved_by_all(const Comparison& comparison) {
  return static_cast<std::size_t>(
      std::count_if(comparison.queries.begin(), comparison.queries.end(), all_found));
}

Summary summary_of(const Comparison& comparison, const Measure& measure, std::size_t planner) {
  const double sign = measure.more_is_better ? -1 : 1;  // so that less is better
  std::vector<double> values;
  for (const ComparedQuery& query : comparison.queries) {
    if (all_found(query)) values.push_back(sign * measure.of(comparison, query, planner));
  }
  const Summary summary = summary_of(std::move(values));
  return {sign * summary.median, sign * summary.mean, sign * summary.p99};
}

std::vector<bool> best_of(std::span<const double> values, bool more_is_better) {
  std::vector<bool> marks(values.size(), false);
  double best = kNothing;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    if (std::isnan(best) || (more_is_better ? value > best : value < best)) best = value;
  }
  const auto is_worse = [best](double value) { return !std::isnan(value) && !equal(best, value); };
  if (std::none_of(values.begin(), values.end(), is_worse)) return marks;
  std::transform(values.begin(), values.end(), marks.begin(),
                 [best](double value) { return equal(best, value); });
  return marks;
}

}  // namespace wend
