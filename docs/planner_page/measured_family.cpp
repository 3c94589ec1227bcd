#include "docs/planner_page/measured_family.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "bench/comparison/comparison_measures.hpp"
#include "bench/measure/statistics.hpp"

namespace wend::planner_page {
namespace {

Comparison compared(const Family& family, Effort effort) {
  std::vector<PlannerSpec> specs;
  specs.reserve(family.planners.size());
  for (const Configuration& planner : family.planners) specs.push_back(planner.spec);
  auto run =
      ComparisonRun::make(family.space, std::move(specs), thread_cpu_seconds, repetition(effort));
  assert(run);
  for (const CellPair& query : family.queries) run->answer(query);
  return std::move(run->comparison());
}

/// The queries that the statistics are about.
Comparison without_partly_solved(Comparison comparison) {
  if (solved_by_all(comparison) == 0) return comparison;
  std::erase_if(comparison.queries, [](const ComparedQuery& query) {
    return !std::all_of(query.rows.begin(), query.rows.end(),
                        [](const ComparisonRow& row) { return row.found(); });
  });
  return comparison;
}

std::vector<double> values_of(const Comparison& comparison, std::string_view key,
                              std::size_t planner) {
  std::vector<double> values;
  values.reserve(comparison.queries.size());
  for (const ComparedQuery& query : comparison.queries) {
    values.push_back(measure(key).of(comparison, query, planner));
  }
  return values;
}

MeasuredPlanner measured(const Comparison& comparison, std::size_t planner) {
  const auto median = [&](std::string_view key) {
    return summary_of(values_of(comparison, key, planner)).median;
  };
  MeasuredPlanner row;
  row.cost = median("cost_ratio");
  row.expanded = median("expanded");
  row.us = median("later_query_us");
  row.clearance = median("clearance_cells");
  const std::vector<double> costs = values_of(comparison, "cost_ratio", planner);
  row.worst_cost = *std::max_element(costs.begin(), costs.end());
  const double expanded = summary_of(values_of(comparison, "expanded", planner)).mean;
  row.ns_an_expansion =
      1000 * summary_of(values_of(comparison, "later_query_us", planner)).mean / expanded;
  return row;
}

}  // namespace

bool MeasuredPlanner::always_cheapest() const {
  constexpr double kRounding = 1e-9;
  return worst_cost <= 1 + kRounding;
}

const MeasuredPlanner* MeasuredFamily::find(std::string_view role) const {
  const auto place =
      std::find_if(planners.begin(), planners.end(),
                   [role](const MeasuredPlanner& planner) { return planner.role == role; });
  return place == planners.end() ? nullptr : &*place;
}

RepetitionRule repetition(Effort effort) {
  return effort == Effort::full ? RepetitionRule{} : RepetitionRule{.fill_seconds = 0};
}

MeasuredFamily measure_planners(const Family& family, Effort effort) {
  const Comparison comparison = compared(family, effort);
  MeasuredFamily result;
  result.title = family.title;
  result.about = family.about;
  result.is_maze = family.is_maze;
  result.uniform_terrain = family.space.uniform_terrain();
  result.eight_neighbours = family.planners.front().spec.text == family.planners.front().role;
  result.queries = comparison.queries.size();
  result.solved_by_all = solved_by_all(comparison);
  const Comparison fair = without_partly_solved(comparison);
  for (std::size_t i = 0; i < family.planners.size(); ++i) {
    MeasuredPlanner row = measured(fair, i);
    row.role = family.planners[i].role;
    row.planner = family.planners[i].spec.text;
    row.solved = solved_by(comparison, i);
    result.planners.push_back(std::move(row));
  }
  const MeasuredPlanner* const astar = result.find("astar");
  for (MeasuredPlanner& row : result.planners) row.us_of_astar = row.us / astar->us;
  return result;
}

}  // namespace wend::planner_page
