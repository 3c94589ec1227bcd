#include "bench/suites/suite_baseline.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "bench/measure/machine.hpp"
#include "bench/suites/suite.hpp"
#include "wend/io/files.hpp"
#include "wend/report/build_info.hpp"

namespace wend::bench {

int compare_with(const Baseline& baseline, const std::vector<BaselineRow>& now) {
  const BaselineVerdict verdict = compared(baseline, now);
  fmt::print("CPU time, {}.\nnow: commit {}, {}\nbaseline: commit {}, {}\n\n{}", baseline.times,
             wend_commit(), describe_machine(), baseline.commit, baseline.machine, verdict.table);
  if (verdict.slower) {
    fmt::print("\nSLOWER: below the baseline by more than {:.0f} %.\n", 100 * baseline.tolerance);
  }
  return verdict.slower ? 1 : 0;
}

void save_baseline(const std::string& file, std::string times, std::size_t sample,
                   std::vector<BaselineRow> rows) {
  const Baseline baseline{.machine = describe_machine(),
                          .commit = std::string(wend_commit()),
                          .times = std::move(times),
                          .sample = sample,
                          .rows = std::move(rows)};
  const auto written = write_file(file, baseline_json(baseline));
  if (!written) throw Refused(written.error().message);
}

}  // namespace wend::bench
