// A comparison as JSON and CSV.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/comparison/comparison_measures.hpp"
#include "wend/base/parse.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr std::string_view kRatio = "cost_ratio";  // follows from the costs

Json row_json(const Comparison& comparison, const ComparedQuery& query, std::size_t planner) {
  const ComparisonRow& row = query.rows[planner];
  Json json{{"planner", row.planner}, {"status", to_string(row.status)}};
  if (!row.found()) json["reason"] = row.reason;
  for (const Measure& measure : measures_of(comparison)) {
    if (!measure.of_path || measure.key == kRatio) continue;
    json[std::string(measure.key)] = measure.of(comparison, query, planner);
  }
  if (row.remaining) {
    json["remaining_cells"] = *row.remaining;
    json["remaining_m"] = *row.remaining * comparison.frame.resolution;
  }
  if (!row.notes.empty()) json["notes"] = row.notes;
  json["metrics"] = json_of(SearchMetrics{row.expanded, row.generated, row.max_frontier});
  json["times"] = {{"preparation_us", in_microseconds(row.times.preparation)},
                   {"first_query_us", in_microseconds(row.times.first)},
                   {"later_query_us", in_microseconds(row.times.later)}};
  return json;
}

/// [x, y] of a cell; for a car, with the heading.
Json json_of_end(const Comparison& comparison, const Goal& end) {
  if (!comparison.capabilities.headings) return json_of(cell_at(end.point));
  Json json = json_of(end.point);
  json.push_back(end.heading ? json_of_heading(*end.heading, comparison.frame) : Json("any"));
  return json;
}

Json query_json(const Comparison& comparison, const ComparedQuery& query) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < query.rows.size(); ++i) {
    rows.push_back(row_json(comparison, query, i));
  }
  Json json{{"start", json_of_end(comparison, query.start)}};
  if (query.goals.size() == 1) {
    json["goal"] = json_of_end(comparison, query.goals.front());
  } else {
    json["goals"] = Json::array();
    for (const Goal& goal : query.goals) json["goals"].push_back(json_of_end(comparison, goal));
  }
  const double tolerance = query.goals.front().tolerance;
  if (tolerance > 0) json["goal_tolerance_cells"] = tolerance;
  json["planners"] = std::move(rows);
  return json;
}

/// The coordinates of one or more ends, each with a comma: "3,4," of one, "3;9,4;8," of two.
std::string end_fields(const Comparison& comparison, const std::vector<Goal>& ends) {
  std::vector<std::string> fields(json_of_end(comparison, ends.front()).size());
  for (const Goal& end : ends) {
    const Json values = json_of_end(comparison, end);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (&end != &ends.front()) fields[i] += ';';
      fields[i] += values[i].is_string() ? values[i].get<std::string>() : values[i].dump();
    }
  }
  std::string text;
  for (const std::string& field : fields) text += field + ',';
  return text;
}

Json statistics_json(const Comparison& comparison, const std::string& name, std::size_t planner) {
  Json json{{"planner", name}, {"solved", solved_by(comparison, planner)}};
  for (const Measure& measure : measures_of(comparison)) {
    if (measure.key == "cost") continue;
    const Summary summary = summary_of(comparison, measure, planner);
    json[std::string(measure.key)] = {{"median", summary.median},
                                      {"mean", summary.mean},
                                      {measure.more_is_better ? "p1" : "p99", summary.p99}};
  }
  return json;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json queries = Json::array();
  for (const ComparedQuery& query : comparison.queries) {
    queries.push_back(query_json(comparison, query));
  }
  Json statistics = Json::array();
  const std::vector<std::string> planners = planners_of(comparison);
  for (std::size_t i = 0; i < planners.size(); ++i) {
    statistics.push_back(statistics_json(comparison, planners[i], i));
  }
  return text_of({{"queries", queries},
                  {"solved_by_all", solved_by_all(comparison)},
                  {"statistics", statistics}});
}

std::string comparison_csv(const Comparison& comparison) {
  const bool headings = comparison.capabilities.headings;
  std::string csv = headings ? "start_x,start_y,start_heading,goal_x,goal_y,goal_heading"
                             : "start_x,start_y,goal_x,goal_y";
  csv += ",planner,status";
  for (const Measure& measure : measures_of(comparison)) {
    if (measure.key != kRatio) csv.append(",").append(measure.key);
  }
  csv += ",reason\n";
  for (const ComparedQuery& query : comparison.queries) {
    for (std::size_t i = 0; i < query.rows.size(); ++i) {
      const ComparisonRow& row = query.rows[i];
      csv += end_fields(comparison, {Goal(query.start)}) + end_fields(comparison, query.goals);
      csv += csv_field(row.planner) + ',';
      csv += to_string(row.status);
      for (const Measure& measure : measures_of(comparison)) {
        if (measure.key == kRatio) continue;
        const double value = measure.of(comparison, query, i);
        csv += ',' + (std::isnan(value) ? "" : format_number(value));
      }
      csv += ',' + csv_field(row.reason) + '\n';
    }
  }
  return csv;
}

}  // namespace wend
