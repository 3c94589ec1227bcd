#include "docs/planner_page/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

#include "bench/comparison/comparison_measures.hpp"
#include "bench/comparison/comparison_run.hpp"
#include "bench/measure/markdown_table.hpp"
#include "bench/measure/statistics.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/report/text_table.hpp"

namespace wend::planner_page {
namespace {

using Value = double MeasuredPlanner::*;
using Field = std::string (*)(const MeasuredMap&, const MeasuredPlanner&, bool is_least);

Comparison compared(const BenchmarkMap& map, Effort effort) {
  std::vector<PlannerSpec> specs;
  specs.reserve(map.planners.size());
  for (const Configuration& planner : map.planners) specs.push_back(planner.spec);
  auto run =
      ComparisonRun::make(map.space, std::move(specs), thread_cpu_seconds, repetition(effort));
  assert(run);
  for (const CellPair& query : map.queries) run->answer(query);
  return std::move(run->comparison());
}

bool solved_by_every_planner(const ComparedQuery& query) {
  return std::all_of(query.rows.begin(), query.rows.end(),
                     [](const ComparisonRow& row) { return row.found(); });
}

MeasuredPlanner measured(const Comparison& comparison, std::size_t planner,
                         const std::string& name) {
  const auto values_of = [&](std::string_view key) {
    std::vector<double> values;
    values.reserve(comparison.queries.size());
    for (const ComparedQuery& query : comparison.queries) {
      values.push_back(measure(key).of(comparison, query, planner));
    }
    return values;
  };
  const std::vector<double> costs = values_of("cost_ratio");
  return {name, summary_of(costs).median, *std::max_element(costs.begin(), costs.end()),
          summary_of(values_of("expanded")).median, summary_of(values_of("later_query_us")).median};
}

/// The planners that any of the maps has, in their order.
std::vector<std::string> names_in(std::span<const MeasuredMap> maps) {
  std::vector<std::string> names;
  for (const MeasuredMap& map : maps) {
    for (const MeasuredPlanner& planner : map.planners) {
      if (std::find(names.begin(), names.end(), planner.name) == names.end()) {
        names.push_back(planner.name);
      }
    }
  }
  return names;
}

/// A row a map and a column a planner.
std::string matrix(std::span<const MeasuredMap> maps, const std::vector<std::string>& names,
                   Value value, Field field) {
  std::vector<TextTable::Column> columns{{"map"}};
  for (const std::string& name : names) {
    columns.push_back({fmt::format("`{}`", name), Align::right});
  }
  MarkdownTable table(std::move(columns));
  for (const MeasuredMap& map : maps) {
    const auto less = [value](const auto& a, const auto& b) { return a.*value < b.*value; };
    const double least = (*std::ranges::min_element(map.planners, less)).*value;
    std::vector<std::string> row{map.title};
    for (const std::string& name : names) {
      const MeasuredPlanner* const planner = map.find(name);
      row.push_back(planner == nullptr ? "–" : field(map, *planner, planner->*value == least));
    }
    table.add(row);
  }
  return table.text();
}

/// Two or three digits that tell ratios apart: "0.0045", "0.31", "2.4", "37".
std::string ratio(double value, bool best) {
  constexpr double kFewDigits = 10;
  constexpr double kOneDigit = 2;
  constexpr double kSmall = 0.1;
  if (value < kSmall) return fmt::format(fmt::runtime(best ? "**{:.2g}**" : "{:.2g}"), value);
  return decimal(value, value >= kFewDigits ? 0 : value >= kOneDigit ? 1 : 2, best);
}

}  // namespace

const MeasuredPlanner* MeasuredMap::find(std::string_view name) const {
  const auto place = std::find_if(planners.begin(), planners.end(),
                                  [name](const auto& planner) { return planner.name == name; });
  return place == planners.end() ? nullptr : &*place;
}

RepetitionRule repetition(Effort effort) {
  return effort == Effort::full ? RepetitionRule{} : RepetitionRule{.fill_seconds = 0};
}

MeasuredMap measure_planners(const BenchmarkMap& map, Effort effort) {
  Comparison comparison = compared(map, effort);
  MeasuredMap result{map.title,
                     map.about,
                     map.space.width(),
                     map.space.height(),
                     map.space.passable().count(),
                     comparison.queries.size(),
                     solved_by_all(comparison),
                     {}};
  std::erase_if(comparison.queries, std::not_fn(solved_by_every_planner));
  assert(!comparison.queries.empty());
  for (std::size_t i = 0; i < map.planners.size(); ++i) {
    result.planners.push_back(measured(comparison, i, map.planners[i].name));
  }
  return result;
}

std::string map_table(std::span<const MeasuredMap> maps) {
  MarkdownTable table({{"map"},
                       {"what it is"},
                       {"cells", Align::right},
                       {"passable", Align::right},
                       {"solved by all", Align::right}});
  for (const MeasuredMap& map : maps) {
    table.add({map.title, map.about, fmt::format("{} x {}", map.width, map.height),
               std::to_string(map.passable),
               fmt::format("{} of {}", map.solved_by_all, map.queries)});
  }
  return table.text();
}

std::string time_table(std::span<const MeasuredMap> maps) {
  return matrix(maps, names_in(maps), &MeasuredPlanner::us,
                [](const MeasuredMap& map, const MeasuredPlanner& planner, bool least) {
                  const MeasuredPlanner& astar = map.planners.front();
                  if (&planner != &astar) return ratio(planner.us / astar.us, least);
                  return decimal(astar.us, 0, least) + " µs";
                });
}

std::string expanded_table(std::span<const MeasuredMap> maps) {
  return matrix(maps, names_in(maps), &MeasuredPlanner::expanded,
                [](const MeasuredMap&, const MeasuredPlanner& planner, bool least) {
                  return decimal(planner.expanded, 0, least);
                });
}

std::string cost_table(std::span<const MeasuredMap> maps) {
  constexpr double kRounding = 1e-9;
  std::vector<std::string> names = names_in(maps);
  std::erase_if(names, [&](const std::string& name) {
    return std::all_of(maps.begin(), maps.end(), [&](const MeasuredMap& map) {
      const MeasuredPlanner* const planner = map.find(name);
      return planner == nullptr || planner->worst_cost <= 1 + kRounding;
    });
  });
  return matrix(maps, names, &MeasuredPlanner::cost,
                [](const MeasuredMap&, const MeasuredPlanner& planner, bool) {
                  return fmt::format("{:.2f} ({:.2f})", planner.cost, planner.worst_cost);
                });
}

std::string decimal(double value, int decimals, bool best) {
  return fmt::format(fmt::runtime(best ? "**{:.{}f}**" : "{:.{}f}"), value, decimals);
}

}  // namespace wend::planner_page
