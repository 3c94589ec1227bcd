#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include "bench/scenario/bench_rows.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/io/text.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr std::size_t kUsualWidth = 80;
constexpr std::size_t kWidest = 16;  // longest planner name beside its numbers in that width
constexpr const char* kIndent = "  ";

/// Four digits; a larger number keeps all its digits before the point.
std::string digits(double value) {
  constexpr int kDigits = 4;
  const int before = value >= 1 ? static_cast<int>(std::log10(value)) + 1 : 1;
  return fmt::format("{:.{}f}", value, std::clamp(kDigits - before, 0, kDigits - 1));
}

/// Length of the folder that all names share, including its slash.
std::size_t common_folder(std::span<const BenchRow> rows) {
  if (rows.empty()) return 0;
  const std::string& first = rows.front().scen;
  std::size_t common = first.find_last_of('/') + 1;  // 0 without one
  for (const BenchRow& row : rows) {
    const auto differ =
        std::mismatch(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(common),
                      row.scen.begin(), row.scen.end());
    const auto same = static_cast<std::size_t>(differ.first - first.begin());
    if (same < common) common = same == 0 ? 0 : first.find_last_of('/', same - 1) + 1;
  }
  return common;
}

/// Faults and unusual results: "12 wrong, 3 without a path".
std::string remarks_on(const BenchRow& row) {
  std::string remarks;
  const auto remark = [&](std::uint64_t count, const char* what) {
    if (count > 0) remarks += fmt::format("{}{} {}", remarks.empty() ? "" : ", ", count, what);
  };
  remark(row.wrong, "wrong");
  remark(row.timed_out, "timed out");
  remark(row.queries - row.solved - row.timed_out, "without a path");
  if (row.passes > 1) {
    remarks += fmt::format("{}{} repetitions, spread {:.1f} %", remarks.empty() ? "" : ", ",
                           row.passes, 100 * row.spread());
  }
  return remarks;
}

class BenchTable {
 public:
  BenchTable(const BenchConditions& conditions, std::span<const BenchRow> rows, std::size_t width)
      : conditions_(conditions),
        rows_(rows),
        longest_(kWidest + std::max(width, kUsualWidth) - kUsualWidth),
        indexes_(std::ranges::any_of(rows, [](const auto& row) { return row.index_bytes > 0; })),
        folder_(common_folder(rows)) {}

  std::string text() const {
    TextTable table(columns());
    for (const BenchRow& row : rows_) table.add(fields_of(row));
    return heading() + with_scenarios(table.text());
  }

 private:
  std::vector<TextTable::Column> columns() const {
    std::vector<TextTable::Column> columns{{"planner"}, {"prepare\nms", Align::right}};
    if (!conditions_.fresh) columns.push_back({"first\nquery", Align::right});
    columns.push_back({conditions_.fresh ? "first\nquery" : "later\nqueries", Align::right});
    columns.push_back({"median", Align::right});
    columns.push_back({"99 %", Align::right});
    columns.push_back({"expanded", Align::right});
    if (indexes_) columns.push_back({"index\nMB", Align::right});
    return columns;
  }

  std::vector<std::string> fields_of(const BenchRow& row) const {
    std::vector<std::string> fields{is_long(row) ? kIndent : kIndent + row.planner,
                                    digits(row.prepare_ms())};
    if (!conditions_.fresh) fields.push_back(digits(row.first_us));
    for (const double value : {row.mean_us, row.median_us, row.p99_us, row.expanded_per_query}) {
      fields.push_back(digits(value));
    }
    if (indexes_) {
      fields.push_back(row.index_bytes > 0 ? digits(1e-6 * static_cast<double>(row.index_bytes))
                                           : "");
    }
    return fields;
  }

  std::string heading() const {
    std::string text =
        fmt::format("{} of the thread, in microseconds a query.\n", thread_time_name());
    text +=
        conditions_.fresh
            ? "Every query is one run of a new planner.\n"
            : "First query: one run of a new planner. Later: least of the runs that fill 5 ms.\n";
    text += fmt::format("Robot: {}.\n", conditions_.robot);
    if (conditions_.limit_s > 0) {
      text += fmt::format("A query may take {} s.\n", conditions_.limit_s);
    }
    const bool threads =
        std::ranges::any_of(rows_, [](const BenchRow& row) { return row.threads > 1; });
    if (threads) text += fmt::format("Threads: {}.\n", rows_.front().threads);
    if (folder_ > 0)
      text += fmt::format("Scenarios in {}.\n", visible(rows_.front().scen.substr(0, folder_)));
    return text + "\n";
  }

  /// Puts a line above the rows of every scenario, names that are too long above their rows, and
  /// remarks after the rows.
  std::string with_scenarios(const std::string& table) const {
    std::size_t at = 0;
    const auto next_line = [&] {
      const std::size_t end = table.find('\n', at) + 1;
      std::string line = table.substr(at, end - at);
      at = end;
      return line;
    };
    std::string text = next_line();
    text += next_line();
    const BenchRow* last = nullptr;
    for (const BenchRow& row : rows_) {
      if (last == nullptr || last->scen != row.scen) {
        text += fmt::format("{}: {} quer{}\n", visible(row.scen.substr(folder_)), row.queries,
                            row.queries == 1 ? "y" : "ies");
      }
      if (is_long(row)) text += kIndent + row.planner + "\n";
      text += next_line();
      const std::string remarks = remarks_on(row);
      if (!remarks.empty()) text += fmt::format("{0}{0}{1}\n", kIndent, remarks);
      last = &row;
    }
    return text;
  }

  bool is_long(const BenchRow& row) const { return row.planner.size() > longest_; }

  const BenchConditions& conditions_;
  std::span<const BenchRow> rows_;
  std::size_t longest_;  // name of a planner beside its numbers
  bool indexes_;
  std::size_t folder_;
};

}  // namespace

std::string bench_table(const BenchConditions& conditions, std::span<const BenchRow> rows,
                        std::size_t width) {
  return BenchTable(conditions, rows, width).text();
}

}  // namespace wend
