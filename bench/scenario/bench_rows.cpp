#include "bench/scenario/bench_rows.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bench/measure/statistics.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr double kMicrosecondsPerSecond = 1e6;  // in a second

/// Mean microseconds per query, for each repetition that all queries have.
std::vector<double> pass_means(std::span<const BenchAnswer> answers, std::size_t passes) {
  std::vector<double> means(passes);
  for (const BenchAnswer& answer : answers) {
    for (std::size_t pass = 0; pass < passes; ++pass) {
      means[pass] +=
          kMicrosecondsPerSecond * answer.seconds[pass] / static_cast<double>(answers.size());
    }
  }
  return means;
}

Json json_of(const BenchRow& row) {
  return {{"scen", row.scen},
          {"planner", row.planner},
          {"queries", row.queries},
          {"solved", row.solved},
          {"timed_out", row.timed_out},
          {"wrong", row.wrong},
          {"prepare_us", row.prepare_us},
          {"first_queries", row.first_queries},
          {"first_us", row.first_us},
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

/// Sets the mean times of new planners over their first queries.
void set_first(BenchRow& row, std::span<const BenchAnswer> answers) {
  double prepare = 0;
  double first = 0;
  for (const BenchAnswer& answer : answers) {
    if (!answer.first) continue;
    ++row.first_queries;
    prepare += answer.first->prepare_s;
    first += answer.first->seconds;
  }
  if (row.first_queries == 0) return;
  row.prepare_us = kMicrosecondsPerSecond * prepare / static_cast<double>(row.first_queries);
  row.first_us = kMicrosecondsPerSecond * first / static_cast<double>(row.first_queries);
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
    timed_out += answer.status == Status::time_limit ? 1 : 0;
    wrong += answer.wrong ? 1 : 0;
    expanded += answer.expanded;
    fastest.push_back(kMicrosecondsPerSecond * answer.fastest());
    least_passes = std::min(least_passes, answer.seconds.size());
  }
  const double total = std::accumulate(fastest.begin(), fastest.end(), 0.0);
  expanded_per_query = static_cast<double>(expanded) / static_cast<double>(queries);
  expansions_per_second =
      total > 0 ? kMicrosecondsPerSecond * static_cast<double>(expanded) / total : 0;
  const Summary summary = summary_of(std::move(fastest));
  mean_us = summary.mean;
  median_us = summary.median;
  p99_us = summary.p99;
  passes = least_passes;
  const std::vector<double> means = pass_means(answers, least_passes);
  fastest_pass_us = *std::min_element(means.begin(), means.end());
  slowest_pass_us = *std::max_element(means.begin(), means.end());
  set_first(*this, answers);
}

double BenchRow::spread() const {
  return fastest_pass_us > 0 ? slowest_pass_us / fastest_pass_us - 1 : 0;
}

std::string bench_json(const BenchConditions& conditions, std::span<const BenchRow> rows) {
  Json json{{"version", conditions.version},
            {"commit", conditions.commit},
            {"machine", conditions.machine},
            {"times", thread_time_name()},
            {"robot", conditions.robot},
            {"fresh", conditions.fresh},
            {"limit_s", conditions.limit_s > 0 ? Json(conditions.limit_s) : Json()},
            {"rows", Json::array()}};
  for (const BenchRow& row : rows) json["rows"].push_back(json_of(row));
  return text_of(json);
}

std::string bench_csv(const BenchConditions& conditions, std::span<const BenchRow> rows) {
  const auto fields_of = [&](const BenchRow& row) {
    Json fields = json_of(row);
    fields["fresh"] = conditions.fresh;
    fields["version"] = conditions.version;
    fields["commit"] = conditions.commit;
    return fields;
  };
  std::string csv;
  const Json names = fields_of(BenchRow());
  for (const auto& [name, value] : names.items()) {
    csv += (csv.empty() ? "" : ",") + name;
  }
  for (const BenchRow& row : rows) {
    char separator = '\n';
    for (const Json& value : fields_of(row)) {
      csv += separator + csv_text(value);
      separator = ',';
    }
  }
  return csv + '\n';
}

}  // namespace wend
