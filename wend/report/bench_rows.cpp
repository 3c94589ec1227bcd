#include "wend/report/bench_rows.hpp"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "wend/report/json.hpp"
#include "wend/report/statistics.hpp"
#include "wend/report/text_table.hpp"

namespace wend {

void BenchRow::set_work(std::vector<double> microseconds, std::uint64_t expanded) {
  if (microseconds.empty()) return;
  const double total = std::accumulate(microseconds.begin(), microseconds.end(), 0.0);
  expanded_per_query = static_cast<double>(expanded) / static_cast<double>(microseconds.size());
  expansions_per_second = total > 0 ? static_cast<double>(expanded) / (total * 1e-6) : 0;
  const Summary summary = summary_of(std::move(microseconds));
  mean_us = summary.mean;
  median_us = summary.median;
  p99_us = summary.p99;
}

std::string bench_json(std::span<const BenchRow> rows) {
  Json json = Json::array();
  for (const BenchRow& row : rows) {
    json.push_back({{"scen", row.scen},
                    {"planner", row.planner},
                    {"queries", row.queries},
                    {"solved", row.solved},
                    {"wrong", row.wrong},
                    {"mean_us", row.mean_us},
                    {"median_us", row.median_us},
                    {"p99_us", row.p99_us},
                    {"expanded_per_query", row.expanded_per_query},
                    {"expansions_per_second", row.expansions_per_second}});
  }
  return text_of(json);
}

std::string bench_table(std::span<const BenchRow> rows) {
  TextTable table({{"scenario"},
                   {"planner"},
                   {"queries", Align::right},
                   {"solved", Align::right},
                   {"wrong", Align::right},
                   {"mean us", Align::right},
                   {"median us", Align::right},
                   {"99 % us", Align::right},
                   {"expanded/query", Align::right},
                   {"million/s", Align::right}});
  for (const BenchRow& row : rows) {
    table.add({row.scen, row.planner, fmt::to_string(row.queries), fmt::to_string(row.solved),
               fmt::to_string(row.wrong), fmt::format("{:.1f}", row.mean_us),
               fmt::format("{:.1f}", row.median_us), fmt::format("{:.1f}", row.p99_us),
               fmt::format("{:.0f}", row.expanded_per_query),
               fmt::format("{:.2f}", row.expansions_per_second * 1e-6)});
  }
  return table.text();
}

}  // namespace wend
