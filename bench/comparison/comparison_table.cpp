#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/comparison/comparison_measures.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr std::size_t kLongestName = 24;

/// A column of numbers, the best of them marked.
struct Column {
  const Measure& measure;
  std::vector<double> values;
  std::vector<bool> best;  // empty: nothing is compared

  /// One word per line.
  std::string title() const {
    std::string text(measure.title);
    if (!measure.unit.empty()) text.append(" ").append(measure.unit);
    const std::string line_end = has_marks() ? " \n" : "\n";
    std::string title;
    for (const char letter : text) letter == ' ' ? title += line_end : title += letter;
    return has_marks() ? title + ' ' : title;
  }

  /// Digits line up with digits, marks with marks.
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

/// Planners that found no path are not compared.
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

/// What was said of planners: a line for each text, with the planners of which it was said first.
class SaidOfPlanners {
 public:
  void add(const std::string& planner, std::string what) {
    const auto line = std::ranges::find(lines_, what, &Line::first);
    if (line == lines_.end()) {
      lines_.emplace_back(std::move(what), planner);
    } else {
      line->second += ", " + planner;
    }
  }

  std::string text() const {
    std::string text;
    for (const auto& [what, planners] : lines_) text += fmt::format("{}: {}\n", planners, what);
    return text;
  }

 private:
  using Line = std::pair<std::string, std::string>;
  std::vector<Line> lines_;
};

/// Why planners failed, and what was done where the robot cannot be.
std::string remarks_of(const ComparedQuery& query) {
  SaidOfPlanners notes;
  SaidOfPlanners failures;
  for (const ComparisonRow& row : query.rows) {
    for (const std::string& note : row.notes) notes.add(row.planner, note);
    if (row.counts_first_query) {
      notes.add(row.planner, "counted in the first query, as its answer is kept");
    }
    if (row.found()) continue;
    std::string why(to_string(row.status));
    if (!row.reason.empty()) why += ": " + row.reason;
    failures.add(row.planner, std::move(why));
  }
  return notes.text() + failures.text();
}

/// Is the measure in the user's unit?
bool has_wanted_unit(const Measure& measure, bool metric) {
  return metric ? !measure.of_cells() : !measure.metric();
}

/// For one query: the measures of paths, or of searches, as far as there is room.
bool is_shown_of_one(const Measure& measure, bool of_path, bool headings) {
  if (measure.key == "cost_ratio" || measure.title == "turning radius") return false;
  if (measure.title == "mean clearance" && headings) return false;
  return measure.of_path == of_path;
}

std::vector<Column> columns_of_one(const Comparison& comparison, bool of_path) {
  std::vector<Column> columns;
  for (const Measure& measure : measures_of(comparison)) {
    if (!has_wanted_unit(measure, comparison.frame.metric)) continue;
    if (!is_shown_of_one(measure, of_path, comparison.capabilities.headings)) continue;
    columns.push_back(column_of(comparison, comparison.queries.front(), measure));
  }
  return columns;
}

TextTable table_of(const ComparedQuery& query, const std::vector<Column>& columns) {
  std::vector<TextTable::Column> titles{{"planner", Align::left, kLongestName}};
  for (const Column& column : columns) titles.push_back({column.title(), Align::right});
  TextTable table(std::move(titles));
  for (std::size_t i = 0; i < query.rows.size(); ++i) {
    std::vector<std::string> fields{query.rows[i].planner};
    for (const Column& column : columns) fields.push_back(column.field(i));
    table.add(std::move(fields));
  }
  return table;
}

/// Explains the curvatures.
std::string curvature_note() {
  return fmt::format("Curvatures and turning radii: corners are rounded within {} cells.\n",
                     kCornerRounding);
}

/// Explains the times.
std::string_view times_note() {
  static const std::string note = fmt::format(
      "Times are {}. prepare: to make the planner for the map. first query: one\n"
      "run of a planner just made. later queries: the quickest of runs that fill 5 ms.\n",
      thread_time_name());
  return note;
}

std::string table_of_one(const Comparison& comparison, std::size_t width) {
  const ComparedQuery& query = comparison.queries.front();
  const std::vector<Column> paths = columns_of_one(comparison, true);
  const std::vector<Column> searches = columns_of_one(comparison, false);
  const bool marked = has_marks(paths) || has_marks(searches);
  std::string text = table_of(query, paths).text(width) + "\n" +
                     table_of(query, searches).text(width) + remarks_of(query);
  if (marked) text += "* best of its column\n";
  text += curvature_note();
  return text.append(times_note());
}

/// Median, mean and percentile of every planner. An infinite mean is left out: the turning
/// radius of a straight path is infinite.
std::vector<Column> columns_of(const Comparison& comparison, const Measure& measure) {
  std::vector<Column> columns(3, Column{measure, {}, {}});
  for (std::size_t i = 0; i < planners_of(comparison).size(); ++i) {
    const Summary summary = summary_of(comparison, measure, i);
    columns[0].values.push_back(summary.median);
    columns[1].values.push_back(std::isinf(summary.mean) ? std::nan("") : summary.mean);
    columns[2].values.push_back(summary.p99);
  }
  for (Column& column : columns) column.best = best_of(column.values, measure.more_is_better);
  return columns;
}

std::string solved_table(const Comparison& comparison, const std::vector<bool>& best) {
  const std::vector<std::string> planners = planners_of(comparison);
  TextTable table({{"planner", Align::left, kLongestName}, {"solved", Align::right}});
  for (std::size_t i = 0; i < planners.size(); ++i) {
    table.add({planners[i], fmt::format("{}{}", solved_by(comparison, i), best[i] ? '*' : ' ')});
  }
  return table.text();
}

/// The planners that solved most queries.
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

/// The three columns of each measure for which more is better, or for which less is.
std::string statistics_table(const std::vector<std::string>& planners,
                             const std::vector<std::vector<Column>>& blocks, bool more_is_better) {
  TextTable table({{"measure"},
                   {"planner", Align::left, kLongestName},
                   {"median ", Align::right},
                   {"mean ", Align::right},
                   {more_is_better ? "1 % least " : "99 % ", Align::right}});
  bool is_first = true;
  for (const std::vector<Column>& columns : blocks) {
    if (columns.front().measure.more_is_better != more_is_better) continue;
    if (!is_first) table.add(std::vector<std::string>(5));
    is_first = false;
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
    text += "No query was solved by every planner: nothing to compare.\n";
    return marked ? text.append("\n").append(kBest) : text;
  }
  std::vector<std::vector<Column>> blocks;
  for (const Measure& measure : measures_of(comparison)) {
    if (!is_shown_of_many(measure, comparison.frame.metric)) continue;
    blocks.push_back(columns_of(comparison, measure));
    marked = marked || has_marks(blocks.back());
  }
  text += fmt::format("Of the {} that every planner solved:\n\n", common);
  const std::vector<std::string> planners = planners_of(comparison);
  text += statistics_table(planners, blocks, false) + "\n";
  text += statistics_table(planners, blocks, true) + "\n";
  if (marked) text += kBest;
  const bool no_mean = std::any_of(blocks.begin(), blocks.end(), [](const auto& columns) {
    const std::vector<double>& means = columns[1].values;
    return std::any_of(means.begin(), means.end(), [](double mean) { return std::isnan(mean); });
  });
  if (no_mean) text += "- there is no mean: some of the values are infinite\n";
  text += "99 %: what 99 of 100 queries do not exceed. 1 % least: what 99 of 100 reach.\n";
  text += curvature_note();
  return text.append(times_note());
}

}  // namespace

std::string comparison_table(const Comparison& comparison, std::size_t width) {
  if (comparison.queries.empty()) return "no queries\n";
  return comparison.queries.size() == 1 ? table_of_one(comparison, width)
                                        : table_of_many(comparison);
}

}  // namespace wend
