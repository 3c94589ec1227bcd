// From path to motion, on large maps: smoothing, simplifying, following.

#include <fmt/format.h>

#include <array>
#include <memory>

#include "bench/measure/measuring.hpp"
#include "bench/suites/motion/motion_row.hpp"
#include "bench/suites/suite.hpp"

namespace wend::bench {
namespace {

constexpr std::array kBenchmarks{smoothing_rows, following_rows};

/// Says whether everything stayed below its bar.
bool run(int rounds) {
  bool all_below = true;
  for (const auto& benchmark : kBenchmarks) {
    for (const MotionRow& row : benchmark(rounds)) {
      const bool below = row.bar_seconds == 0 || row.seconds < row.bar_seconds;
      all_below = all_below && below;
      fmt::print("  {:<54} {:>10.2f} us  {}{}\n", row.name, row.seconds * 1e6, row.note,
                 below ? "" : fmt::format("  ABOVE {:.2f} us", row.bar_seconds * 1e6));
    }
  }
  return all_below;
}

}  // namespace

Measure add_motion(CLI::App& app) {
  const auto rounds = std::make_shared<int>(20);
  add_rounds(app, *rounds);
  return [rounds] {
    stay_on_one_core();
    return run(*rounds) ? 0 : 1;
  };
}

}  // namespace wend::bench
