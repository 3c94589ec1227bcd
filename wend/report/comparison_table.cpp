#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "wend/report/comparison_measures.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

/// A column of numbers, the best of them marked.
struct Column {
  const Measure& measure;
  std::vector<double> values;
  std::vector<bool> best;  // empty: nothing is compared

  std::string title() const {
    const std::string end = has_marks() ? " " : "";
    std::string title = std::string(measure.title) + end;
    if (!measure.unit.empty()) title.append("\n").append(measure.unit).append(end);
    return title;
  }

  /// Digits stand below digits, marks below marks.
  std::string field(std::size_t row) const {
    const double value = values[row];
    if (std::isnan(value)) return has_marks() ? "- " : "-";
    const std::string number = fmt::format("{:.{}f}", value, measure.decimals);
    return has_marks() ? number + (best[row] ? '*' : ' ') : number;
  }

  bool has_marks() const { return std::find(best.begin(), best.end(), true) != best.end(); }
};

bool has_marks(const std::vector<Column>& columns) {
  return std::any_of(columns.begin(), columns.end(),
                     [](const Column& column) { return column.has_marks(); });
}

/// Who found no path takes no part in what is compared.
Column column_of(const Comparison& comparison, const ComparedQuery& query, const Measure& measure) {
  Column column{measure, {}, {}};
  std::vector<double> competing;
  for (std::size_t i = 0; i < query.rows.size(); ++i) {
    column.values.push_back(measure.of(comparison, query, i));
    competing.push_back(query.rows[i].found() ? column.values.back() : std::nan(""));
  }
  column.best = best_of(competing, measure.more_is_better);
  return column;
}

/// A line for each reason, after the planners that it stopped.
std::string reasons_of(const ComparedQuery& query) {
  std::vector<std::pair<std::string, std::string>> lines;  // the reason, the planners
  for (const ComparisonRow& row : query.rows) {
    if (row.found() || row.reason.empty()) continue;
    const auto line = std::find_if(lines.begin(), lines.end(),
                                   [&](const auto& each) { return each.first == row.reason; });
    if (line == lines.end()) {
      lines.emplace_back(row.reason, row.planner);
    } else {
      line->second += ", " + row.planner;
    }
  }
  std::string text;
  for (const auto& [reason, planners] : lines) text += fmt::format("{}: {}\n", planners, reason);
  return text;
}

/// In the unit that people mean.
bool has_wanted_unit(const Measure& measure, bool metric) {
  return metric ? !measure.of_cells() : !measure.metric();
}

/// Of one query: what paths are, or what searches took, as far as there is room.
bool is_shown_of_one(const Measure& measure, bool of_path, Motion motion) {
  if (measure.key == "cost_ratio" || measure.title == "turning radius") return false;
  if (measure.title == "mean clearance" && motion == Motion::car) return false;
  return measure.of_path == of_path;
}

std::vector<Column> columns_of_one(const Comparison& comparison, bool of_path) {
  std::vector<Column> columns;
  for (const Measure& measure : measures_of(comparison)) {
    if (!has_wanted_unit(measure, comparison.frame.metric)) continue;
    if (!is_shown_of_one(measure, of_path, comparison.motion)) continue;
    columns.push_back(column_of(comparison, comparison.queries.front(), measure));
  }
  return columns;
}

std::string table_of(const ComparedQuery& query, const std::vector<Column>& columns,
                     bool with_status) {
  std::vector<TextTable::Column> titles{{"planner"}};
  if (with_status) titles.push_back({"status"});
  for (const Column& column : columns) titles.push_back({column.title(), Align::right});
  TextTable table(std::move(titles));
  for (std::size_t i = 0; i < query.rows.size(); ++i) {
    const ComparisonRow& row = query.rows[i];
    std::vector<std::string> fields{row.planner};
    if (with_status) fields.emplace_back(to_string(row.status));
    for (const Column& column : columns) fields.push_back(column.field(i));
    table.add(std::move(fields));
  }
  return table.text();
}

std::string table_of_one(const Comparison& comparison) {
  const ComparedQuery& query = comparison.queries.front();
  const std::vector<Column> paths = columns_of_one(comparison, true);
  const std::vector<Column> searches = columns_of_one(comparison, false);
  const bool marked = has_marks(paths) || has_marks(searches);
  return table_of(query, paths, true) + "\n" + table_of(query, searches, false) +
         reasons_of(query) + (marked ? "* best of its column\n" : "");
}

/// Median, mean and 99th percentile of every planner.
std::vector<Column> columns_of(const Comparison& comparison, const Measure& measure) {
  std::vector<Column> columns(3, Column{measure, {}, {}});
  for (std::size_t i = 0; i < planners_of(comparison).size(); ++i) {
    const Summary summary = summary_of(comparison, measure, i);
    columns[0].values.push_back(summary.median);
    columns[1].values.push_back(summary.mean);
    columns[2].values.push_back(summary.p99);
  }
  for (Column& column : columns) column.best = best_of(column.values, measure.more_is_better);
  return columns;
}

std::string solved_table(const Comparison& comparison, const std::vector<bool>& best) {
  const std::vector<std::string> planners = planners_of(comparison);
  TextTable table({{"planner"}, {"solved", Align::right}});
  for (std::size_t i = 0; i < planners.size(); ++i) {
    table.add({planners[i], fmt::format("{}{}", solved_by(comparison, i), best[i] ? '*' : ' ')});
  }
  return table.text();
}

/// Who solved most queries.
std::vector<bool> best_solvers(const Comparison& comparison) {
  std::vector<double> solved;
  for (std::size_t i = 0; i < planners_of(comparison).size(); ++i) {
    solved.push_back(static_cast<double>(solved_by(comparison, i)));
  }
  return best_of(solved, true);
}

bool is_shown_of_many(const Measure& measure, bool metric) {
  return measure.key != "cost" && has_wanted_unit(measure, metric);
}

/// "length, m"
std::string title_with_unit(const Measure& measure) {
  std::string title(measure.title);
  if (!measure.unit.empty()) title.append(", ").append(measure.unit);
  return title;
}

/// The three columns of a measure, for every measure.
std::string statistics_table(const std::vector<std::string>& planners,
                             const std::vector<std::vector<Column>>& blocks) {
  TextTable table({{"measure"},
                   {"planner"},
                   {"median ", Align::right},
                   {"mean ", Align::right},
                   {"99 % ", Align::right}});
  for (const std::vector<Column>& columns : blocks) {
    if (&columns != &blocks.front()) table.add(std::vector<std::string>(5));
    for (std::size_t i = 0; i < planners.size(); ++i) {
      std::vector<std::string> fields{i == 0 ? title_with_unit(columns.front().measure) : "",
                                      planners[i]};
      for (const Column& column : columns) {
        fields.push_back(column.field(i) + (column.has_marks() ? "" : " "));
      }
      table.add(std::move(fields));
    }
  }
  return table.text();
}

std::string table_of_many(const Comparison& comparison) {
  constexpr std::string_view kBest = "* best of the planners\n";
  const std::vector<bool> solvers = best_solvers(comparison);
  bool marked = std::find(solvers.begin(), solvers.end(), true) != solvers.end();
  std::string text = fmt::format("{} queries\n\n", comparison.queries.size());
  text += solved_table(comparison, solvers) + "\n";
  const std::size_t common = solved_by_all(comparison);
  if (common == 0) {
    text += "There is none that every planner solved: nothing to compare.\n";
    return marked ? text.append("\n").append(kBest) : text;
  }
  std::vector<std::vector<Column>> blocks;
  for (const Measure& measure : measures_of(comparison)) {
    if (!is_shown_of_many(measure, comparison.frame.metric)) continue;
    blocks.push_back(columns_of(comparison, measure));
    marked = marked || has_marks(blocks.back());
  }
  text += fmt::format("Of the {} that every planner solved:\n\n", common);
  text += statistics_table(planners_of(comparison), blocks) + "\n";
  if (marked) text += kBest;
  return text + "99 %: so many of 100 queries did no worse\n";
}

}  // namespace

std::string comparison_table(const Comparison& comparison) {
  if (comparison.queries.empty()) return "no queries\n";
  return comparison.queries.size() == 1 ? table_of_one(comparison) : table_of_many(comparison);
}

}  // namespace wend
