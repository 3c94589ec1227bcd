#include "bench/comparison/comparison_measures.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

#include "wend/base/metric.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/search/search_metrics.hpp"

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

/// Whole eighths of a turn come out as whole degrees.
double degrees_without_rounding(double radians) {
  constexpr double kDigits = 1e6;
  return std::round(degrees_from(radians) * kDigits) / kDigits;
}

/// How a metric is compared. Others are told to programs only.
struct Shown {
  std::string_view metric;
  std::string_view key;  // empty: it is not compared
  std::string_view title = {};
  bool more_is_better = false;
  bool of_cars = false;
};

constexpr std::array kShown{
    Shown{"length", "length", "length"},
    Shown{"turning", "turning", "turning"},
    Shown{"smallest_turning_radius", ""},
    Shown{"rounded_turning_radius", "turning_radius", "turning radius", true},
    Shown{"corner_rounding", ""},
    Shown{"reversals", "reversals", "reversals", false, true},
    Shown{"smallest_clearance", "clearance", "clearance", true},
    Shown{"mean_clearance", "mean_clearance", "mean clearance", true},
    Shown{"expanded", "expanded", "expanded"},
    Shown{"generated", "generated", "generated"},
    Shown{"max_frontier", "max_frontier", "frontier"}};

/// A measure of a length: in cells, and in metres.
void add_length(std::vector<Measure>& measures, Measure measure) {
  const std::string name = measure.key;
  measure.decimals = 2;
  measure.key = name + "_cells";
  measure.unit = "cells";
  measures.push_back(measure);
  measure.key = name + "_m";
  measure.unit = "m";
  measure.in_metres = true;
  measures.push_back(std::move(measure));
}

/// Adds a metric that is at a place of its list.
template <class Metrics>
void add_metric(std::vector<Measure>& measures, const Metric& metric, std::size_t place,
                Metrics ComparisonRow::* list) {
  const auto* const found = std::ranges::find(kShown, metric.name, &Shown::metric);
  const Shown shown = found == kShown.end() ? Shown{metric.name, metric.name} : *found;
  if (shown.key.empty()) return;
  Measure measure{.key = std::string(shown.key),
                  .title = shown.title,
                  .of_path = std::is_same_v<Metrics, PathMetrics>,
                  .of_cars = shown.of_cars,
                  .more_is_better = shown.more_is_better,
                  .value = [list, place](const ComparedQuery&, const ComparisonRow& row) {
                    return metrics_of(row.*list)[place].value;
                  }};
  if (metric.unit == MetricUnit::cells) return add_length(measures, std::move(measure));
  if (metric.unit == MetricUnit::radians) {
    measure.key += "_degrees";
    measure.unit = "degrees";
    measure.value = [of = std::move(measure.value)](const auto& query, const auto& row) {
      return degrees_without_rounding(of(query, row));
    };
  }
  measures.push_back(std::move(measure));
}

/// Adds all metrics of a list: first those that people see, in their order.
template <class Metrics>
void add_metrics(std::vector<Measure>& measures, Metrics ComparisonRow::* list) {
  const auto metrics = metrics_of(Metrics{});
  std::vector<std::size_t> places(metrics.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::ranges::stable_sort(places, {}, [&](std::size_t place) {
    return std::ranges::find(kShown, metrics[place].name, &Shown::metric) - kShown.begin();
  });
  for (const std::size_t place : places) add_metric(measures, metrics[place], place, list);
}

void add_time(std::vector<Measure>& measures, std::string_view key, std::string_view title,
              double QueryTimes::* time) {
  measures.push_back({.key = std::string(key),
                      .title = title,
                      .unit = "us",
                      .decimals = 1,
                      .value = [time](const ComparedQuery&, const ComparisonRow& row) {
                        return row.times.*time * 1e6;
                      }});
}

/// Adds a measure that is not a metric.
void add_before(std::vector<Measure>& measures, std::string_view key, Measure measure) {
  measures.insert(std::ranges::find(measures, key, &Measure::key), std::move(measure));
}

std::vector<Measure> all_measures() {
  const auto cost = [](const ComparedQuery&, const ComparisonRow& row) { return row.cost; };
  const auto steps = [](const ComparedQuery&, const ComparisonRow& row) {
    return static_cast<double>(row.steps);
  };
  const auto curvature = [](const ComparedQuery&, const ComparisonRow& row) {
    return 1 / row.measured.rounded_turning_radius;
  };
  std::vector<Measure> all{
      {.key = "cost", .title = "cost", .decimals = 2, .of_path = true, .value = cost},
      {.key = "cost_ratio",
       .title = "cost / least",
       .decimals = 3,
       .of_path = true,
       .value = cost_ratio}};
  add_metrics(all, &ComparisonRow::measured);
  Measure bends{.key = "curvature_per_cell",
                .title = "curvature",
                .unit = "1/cells",
                .decimals = 2,
                .of_path = true,
                .value = curvature};
  add_before(all, "turning_radius_cells", bends);
  bends.key = "curvature_per_m";
  bends.unit = "1/m";
  bends.per_metre = true;
  add_before(all, "turning_radius_cells", std::move(bends));
  add_before(all, "reversals",
             {.key = "steps", .title = "steps", .of_path = true, .of_cars = true, .value = steps});
  add_metrics(all, &ComparisonRow::metrics);
  add_time(all, "preparation_us", "prepare", &QueryTimes::preparation);
  add_time(all, "first_query_us", "first query", &QueryTimes::first);
  add_time(all, "later_query_us", "later queries", &QueryTimes::later);
  return all;
}

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = all_measures();
  return all;
}

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
  std::vector<std::reference_wrapper<const Measure>> shown;
  for (const Measure& measure : measures()) {
    if (!measure.of_cars || comparison.capabilities.headings) shown.emplace_back(measure);
  }
  return shown;
}

const Measure& measure(std::string_view key) {
  const auto place = std::ranges::find(measures(), key, &Measure::key);
  assert(place != measures().end());
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
