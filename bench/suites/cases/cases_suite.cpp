// Cases that were slow once, each beside one search of Boost.Graph's A*.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bench/measure/machine.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/suites/cases/cases.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_baseline.hpp"
#include "wend/report/text_table.hpp"

namespace wend::bench {
namespace {

constexpr const char* kTimes =
    "times as fast as one search of Boost.Graph's A* on an office of 1024 x 1024 cells";

struct Arguments {
  std::string only;           // a part of a subject
  int rounds = 5;             // the least time counts
  std::string baseline;       // to compare with
  std::string save_baseline;  // to write
};

struct Timed {
  BaselineRow row;
  double seconds;
};

/// A case and the yardstick in turns.
Timed timed(const Case& each, const Case& yardstick, int rounds) {
  double least = std::numeric_limits<double>::infinity();
  double yard = least;
  for (int round = 0; round < rounds; ++round) {
    yard = std::min(yard, yardstick.run());
    least = std::min(least, each.run());
  }
  return {{each.subject, each.measure, yard / least}, least};
}

std::vector<Timed> measured(const Arguments& arguments) {
  stay_on_one_core();
  const Case yardstick = boost_case();
  std::vector<Timed> all;
  for (const Case& each : all_cases()) {
    if (each.subject.find(arguments.only) == std::string::npos) continue;
    if (isatty(STDERR_FILENO) != 0)
      fmt::print(stderr, "\r\033[K{}, {}", each.subject, each.measure);
    all.push_back(timed(each, yardstick, arguments.rounds));
  }
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
  if (all.empty()) throw Refused("no case's subject contains " + arguments.only);
  return all;
}

void show(const std::vector<Timed>& all) {
  TextTable table({{"subject"}, {"measure"}, {"ms", Align::right}, {"times", Align::right}});
  for (const auto& [row, seconds] : all) {
    table.add({row.subject, row.measure, fmt::format("{:.3f}", 1e3 * seconds),
               fmt::format("{:.3g}", row.ratio)});
  }
  fmt::print("CPU time, {}. {}.\n\n{}", kTimes, describe_machine(), table.text());
}

int run(const Arguments& arguments) {
  const std::vector<Timed> all = measured(arguments);
  std::vector<BaselineRow> rows;
  rows.reserve(all.size());
  for (const Timed& each : all) rows.push_back(each.row);
  if (!arguments.baseline.empty()) {
    return compare_with(value_or_refuse(read_baseline(arguments.baseline)), rows);
  }
  show(all);
  if (!arguments.save_baseline.empty()) save_baseline(arguments.save_baseline, kTimes, 1, rows);
  return 0;
}

}  // namespace

Measure add_cases(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("--only", arguments->only, "cases whose subject contains this");
  add_rounds(app, arguments->rounds);
  app.add_option("--baseline", arguments->baseline,
                 "compare with the ratios in this file; exit code 1 if a case got slower");
  app.add_option("--save-baseline", arguments->save_baseline, "write the ratios to this file");
  return [arguments] { return run(*arguments); };
}

}  // namespace wend::bench
