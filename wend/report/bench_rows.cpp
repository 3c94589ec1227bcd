#include "wend/report/bench_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/report/csv.hpp"
#include "wend/report/json.hpp"
#include "wend/report/statistics.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr double kMicroseconds = 1e6;  // in a second

/// Microseconds a query, of every pass that all queries have.
std::vector<double> pass_means(std::span<const BenchAnswer> answers, std::size_t passes) {
  std::vector<double> means(passes);
  for (const BenchAnswer& answer : answers) {
    for (std::size_t pass = 0; pass < passes; ++pass) {
      means[pass] += kMicroseconds * answer.seconds[pass] / static_cast<double>(answers.size());
    }
  }
  return means;
}

Json json_of(const BenchRow& row) {
  return {{"scen", row.scen},
          {"planner", row.planner},
          {"queries", row.queries},
          {"solved", row.solved},
          {"wrong", row.wrong},
          {"mean_us", row.mean_us},
          {"median_us", row.median_us},
          {"p99_us", row.p99_us},
          {"expanded_per_query", row.expanded_per_query},
          {"expansions_per_second", row.expansions_per_second},
          {"threads", row.threads},
          {"passes", row.passes},
          {"fastest_pass_us", row.fastest_pass_us},
          {"slowest_pass_us", row.slowest_pass_us},
          {"spread", row.spread()},
          {"build_s", row.build_s},
          {"index_bytes", row.index_bytes}};
}

std::string csv_text(const Json& value) {
  if (value.is_string()) return csv_field(value.get<std::string>());
  return value.is_number_float() ? format_number(value.get<double>()) : value.dump();
}

/// Microseconds for people: four digits of what is quick.
std::string microseconds(double value) {
  constexpr double kQuick = 10;
  return value < kQuick ? fmt::format("{:.3f}", value) : fmt::format("{:.1f}", value);
}

}  // namespace

void BenchRow::set_answers(std::span<const BenchAnswer> answers) {
  if (answers.empty()) return;
  std::vector<double> fastest;
  std::size_t least_passes = answers.front().seconds.size();
  std::uint64_t expanded = 0;
  queries = answers.size();
  for (const BenchAnswer& answer : answers) {
    solved += answer.found() ? 1 : 0;
    wrong += answer.wrong ? 1 : 0;
    expanded += answer.expanded;
    fastest.push_back(kMicroseconds * answer.fastest());
    least_passes = std::min(least_passes, answer.seconds.size());
  }
  const double total = std::accumulate(fastest.begin(), fastest.end(), 0.0);
  expanded_per_query = static_cast<double>(expanded) / static_cast<double>(queries);
  expansions_per_second = total > 0 ? kMicroseconds * static_cast<double>(expanded) / total : 0;
  const Summary summary = summary_of(std::move(fastest));
  mean_us = summary.mean;
  median_us = summary.median;
  p99_us = summary.p99;
  passes = least_passes;
  const std::vector<double> means = pass_means(answers, least_passes);
  fastest_pass_us = *std::min_element(means.begin(), means.end());
  slowest_pass_us = *std::max_element(means.begin(), means.end());
}

double BenchRow::spread() const {
  return fastest_pass_us > 0 ? slowest_pass_us / fastest_pass_us - 1 : 0;
}

std::string bench_json(std::span<const BenchRow> rows) {
  Json json = Json::array();
  for (const BenchRow& row : rows) json.push_back(json_of(row));
  return text_of(json);
}

std::string bench_csv(std::span<const BenchRow> rows) {
  std::string csv;
  const Json names = json_of(BenchRow());
  for (const auto& [name, value] : names.items()) {
    csv += (csv.empty() ? "" : ",") + name;
  }
  for (const BenchRow& row : rows) {
    char separator = '\n';
    for (const Json& value : json_of(row)) {
      csv += separator + csv_text(value);
      separator = ',';
    }
  }
  return csv + '\n';
}

std::string bench_table(std::span<const BenchRow> rows) {
  const bool several_passes =
      std::any_of(rows.begin(), rows.end(), [](const BenchRow& row) { return row.passes > 1; });
  const bool indexes = std::any_of(rows.begin(), rows.end(),
                                   [](const BenchRow& row) { return row.index_bytes > 0; });
  std::vector<TextTable::Column> columns{{"scenario"},
                                         {"planner"},
                                         {"queries", Align::right},
                                         {"solved", Align::right},
                                         {"wrong", Align::right},
                                         {"mean us", Align::right},
                                         {"median us", Align::right},
                                         {"99 % us", Align::right},
                                         {"expanded/query", Align::right},
                                         {"million/s", Align::right}};
  if (several_passes) columns.push_back({"spread", Align::right});
  if (indexes) columns.push_back({"build s", Align::right});
  if (indexes) columns.push_back({"index MB", Align::right});
  TextTable table(std::move(columns));
  for (const BenchRow& row : rows) {
    std::vector<std::string> fields{row.scen,
                                    row.planner,
                                    fmt::to_string(row.queries),
                                    fmt::to_string(row.solved),
                                    fmt::to_string(row.wrong),
                                    microseconds(row.mean_us),
                                    microseconds(row.median_us),
                                    microseconds(row.p99_us),
                                    fmt::format("{:.0f}", row.expanded_per_query),
                                    fmt::format("{:.2f}", row.expansions_per_second * 1e-6)};
    if (several_passes) fields.push_back(fmt::format("{:.1f} %", 100 * row.spread()));
    if (indexes) fields.push_back(fmt::format("{:.2f}", row.build_s));
    if (indexes) {
      fields.push_back(fmt::format("{:.2f}", static_cast<double>(row.index_bytes) * 1e-6));
    }
    table.add(std::move(fields));
  }
  return table.text();
}

}  // namespace wend
