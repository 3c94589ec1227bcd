#include "docs/planner_page/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "bench/comparison/comparison_measures.hpp"
#include "docs/planner_page/markdown.hpp"
#include "wend/report/text_table.hpp"

namespace wend::planner_page {
namespace {

/// A column of numbers.
struct Column {
  std::string title;
  int decimals;
  bool more_is_better;
  double MeasuredPlanner::* value;
};

/// The fields of a table below the first column, the best of each column in bold.
std::vector<std::vector<std::string>> fields_of(const MeasuredFamily& family,
                                                const std::vector<Column>& columns) {
  std::vector<std::vector<std::string>> rows(family.planners.size());
  for (const Column& column : columns) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const MeasuredPlanner& planner : family.planners) values.push_back(planner.*column.value);
    const std::vector<bool> best = best_of(values, column.more_is_better);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].push_back(number(values[i], column.decimals, best[i]));
    }
  }
  return rows;
}

std::string table_of(const MeasuredFamily& family, const std::vector<Column>& columns) {
  std::vector<TextTable::Column> titles{{"planner"}, {"solved", Align::right}};
  for (const Column& column : columns) titles.push_back({column.title, Align::right});
  MarkdownTable table(std::move(titles));
  const auto fields = fields_of(family, columns);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const MeasuredPlanner& planner = family.planners[i];
    std::vector<std::string> row{code(planner.planner),
                                 fmt::format("{} of {}", planner.solved, family.queries)};
    row.insert(row.end(), fields[i].begin(), fields[i].end());
    table.add(row);
  }
  return table.text();
}

/// The roles that any of the families has, in their order.
std::vector<std::string> roles_in(std::span<const MeasuredFamily> families) {
  std::vector<std::string> roles;
  for (const MeasuredFamily& family : families) {
    for (const MeasuredPlanner& planner : family.planners) {
      if (std::find(roles.begin(), roles.end(), planner.role) == roles.end()) {
        roles.push_back(planner.role);
      }
    }
  }
  return roles;
}

}  // namespace

std::string family_table(const MeasuredFamily& family) {
  using Row = MeasuredPlanner;
  return table_of(family, {{"cost / cheapest", 3, false, &Row::cost},
                           {"worst", 3, false, &Row::worst_cost},
                           {"expanded", 0, false, &Row::expanded},
                           {"time, µs", 1, false, &Row::us},
                           {"time / astar's", 2, false, &Row::us_of_astar},
                           {"clearance, cells", 2, true, &Row::clearance}});
}

std::string no_path_table(const MeasuredFamily& family) {
  using Row = MeasuredPlanner;
  return table_of(family,
                  {{"expanded", 0, false, &Row::expanded}, {"time, µs", 2, false, &Row::us}});
}

std::string overview_table(std::span<const MeasuredFamily> families) {
  const std::vector<std::string> roles = roles_in(families);
  std::vector<TextTable::Column> columns{{"map"}, {"`astar`, µs", Align::right}};
  for (const std::string& role : roles) columns.push_back({code(role), Align::right});
  MarkdownTable table(std::move(columns));
  for (const MeasuredFamily& family : families) {
    const MeasuredPlanner* const fastest =
        least(family, std::mem_fn(&MeasuredPlanner::us), [](const auto&) { return true; });
    std::vector<std::string> row{link_to(family.title), number(family.find("astar")->us, 0)};
    for (const std::string& role : roles) {
      const MeasuredPlanner* const planner = family.find(role);
      row.push_back(planner == nullptr ? "-" : number(planner->us_of_astar, 2, planner == fastest));
    }
    table.add(row);
  }
  return table.text();
}

std::string wins_table(std::span<const MeasuredFamily> families) {
  MarkdownTable table({{"planner"},
                       {"fastest", Align::right},
                       {"fastest with cheapest paths", Align::right},
                       {"fewest expansions", Align::right}});
  const auto any = [](const MeasuredPlanner&) { return true; };
  const auto cheapest = [](const MeasuredPlanner& planner) { return planner.always_cheapest(); };
  for (const std::string& role : roles_in(families)) {
    const auto wins = [&](double MeasuredPlanner::* value, const auto& qualifies) {
      return std::count_if(families.begin(), families.end(), [&](const MeasuredFamily& family) {
        const MeasuredPlanner* const planner = family.find(role);
        const MeasuredPlanner* const best = least(family, std::mem_fn(value), qualifies);
        return planner != nullptr && best != nullptr && qualifies(*planner) &&
               planner->*value == best->*value;
      });
    };
    table.add({code(role), std::to_string(wins(&MeasuredPlanner::us, any)),
               std::to_string(wins(&MeasuredPlanner::us, cheapest)),
               std::to_string(wins(&MeasuredPlanner::expanded, any))});
  }
  return table.text();
}

}  // namespace wend::planner_page
