#include "bench/comparison/comparison_measures.hpp"

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
double radius(const ComparedQuery&, const ComparisonRow& row) { return 1 / row.largest_curvature; }
double clearance(const ComparedQuery&, const ComparisonRow& row) { return row.smallest_clearance; }

/// A member of a row, as a number.
template <auto kMember>
double value(const ComparedQuery&, const ComparisonRow& row) {
  return static_cast<double>(row.*kMember);
}

template <auto kTime>
double microseconds(const ComparedQuery&, const ComparisonRow& row) {
  return row.times.*kTime * 1e6;
}

constexpr std::array kMeasures{
    Measure{.key = "cost",
            .title = "cost",
            .decimals = 2,
            .of_path = true,
            .value = value<&ComparisonRow::cost>},
    Measure{.key = "cost_ratio",
            .title = "cost / least",
            .decimals = 3,
            .of_path = true,
            .value = cost_ratio},
    Measure{.key = "length_cells",
            .title = "length",
            .unit = "cells",
            .decimals = 2,
            .of_path = true,
            .value = length},
    Measure{.key = "length_m",
            .title = "length",
            .unit = "m",
            .decimals = 2,
            .of_path = true,
            .in_metres = true,
            .value = length},
    Measure{.key = "turning_degrees",
            .title = "turning",
            .unit = "degrees",
            .of_path = true,
            .value = value<&ComparisonRow::turning>},
    Measure{.key = "curvature_per_cell",
            .title = "curvature",
            .unit = "1/cells",
            .decimals = 2,
            .of_path = true,
            .value = value<&ComparisonRow::largest_curvature>},
    Measure{.key = "curvature_per_m",
            .title = "curvature",
            .unit = "1/m",
            .decimals = 2,
            .of_path = true,
            .per_metre = true,
            .value = value<&ComparisonRow::largest_curvature>},
    Measure{.key = "turning_radius_cells",
            .title = "turning radius",
            .unit = "cells",
            .decimals = 2,
            .of_path = true,
            .more_is_better = true,
            .value = radius},
    Measure{.key = "turning_radius_m",
            .title = "turning radius",
            .unit = "m",
            .decimals = 2,
            .of_path = true,
            .more_is_better = true,
            .in_metres = true,
            .value = radius},
    Measure{.key = "steps",
            .title = "steps",
            .of_path = true,
            .of_cars = true,
            .value = value<&ComparisonRow::steps>},
    Measure{.key = "reversals",
            .title = "reversals",
            .of_path = true,
            .of_cars = true,
            .value = value<&ComparisonRow::reversals>},
    Measure{.key = "clearance_cells",
            .title = "clearance",
            .unit = "cells",
            .decimals = 2,
            .of_path = true,
            .more_is_better = true,
            .value = clearance},
    Measure{.key = "clearance_m",
            .title = "clearance",
            .unit = "m",
            .decimals = 2,
            .of_path = true,
            .more_is_better = true,
            .in_metres = true,
            .value = clearance},
    Measure{.key = "mean_clearance_cells",
            .title = "mean clearance",
            .unit = "cells",
            .decimals = 2,
            .of_path = true,
            .more_is_better = true,
            .value = value<&ComparisonRow::mean_clearance>},
    Measure{.key = "mean_clearance_m",
            .title = "mean clearance",
            .unit = "m",
            .decimals = 2,
            .of_path = true,
            .more_is_better = true,
            .in_metres = true,
            .value = value<&ComparisonRow::mean_clearance>},
    Measure{.key = "expanded", .title = "expanded", .value = value<&ComparisonRow::expanded>},
    Measure{.key = "generated", .title = "generated", .value = value<&ComparisonRow::generated>},
    Measure{
        .key = "max_frontier", .title = "frontier", .value = value<&ComparisonRow::max_frontier>},
    Measure{.key = "preparation_us",
            .title = "prepare",
            .unit = "us",
            .decimals = 1,
            .value = microseconds<&QueryTimes::preparation>},
    Measure{.key = "first_query_us",
            .title = "first query",
            .unit = "us",
            .decimals = 1,
            .value = microseconds<&QueryTimes::first>},
    Measure{.key = "later_query_us",
            .title = "later queries",
            .unit = "us",
            .decimals = 1,
            .value = microseconds<&QueryTimes::later>}};

bool all_found(const ComparedQuery& query) {
  return std::all_of(query.rows.begin(), query.rows.end(),
                     [](const ComparisonRow& row) { return row.found(); });
}

}  // namespace

double Measure::of(const Comparison& comparison, const ComparedQuery& query,
                   std::size_t planner) const {
  const ComparisonRow& row = query.rows[planner];
  if (of_path && !row.found()) return kNothing;
  const double resolution = comparison.frame.resolution;
  return value(query, row) * (in_metres ? resolution : per_metre ? 1 / resolution : 1);
}

std::vector<std::reference_wrapper<const Measure>> measures_of(const Comparison& comparison) {
  std::vector<std::reference_wrapper<const Measure>> measures;
  for (const Measure& measure : kMeasures) {
    if (!measure.of_cars || comparison.capabilities.headings) measures.emplace_back(measure);
  }
  return measures;
}

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
    if (!all_found(query)) continue;
    const double value = measure.of(comparison, query, planner);
    if (!std::isnan(value)) values.push_back(sign * value);
  }
  const Summary summary = summary_of(std::move(values));
  const auto value = [sign](double signed_value) { return sign * signed_value + 0.0; };  // no -0
  return {value(summary.median), value(summary.mean), value(summary.p99)};
}

}  // namespace wend
