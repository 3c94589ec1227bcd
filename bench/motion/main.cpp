// wend-motion-speed: from path to motion, on large maps: smoothing, simplifying, following.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <string_view>

#include "bench/measure/command.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/motion/motion_row.hpp"

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

void fail(std::string_view what) {
  fmt::print(stderr, "wend-motion-speed: {}\n", what);
  std::exit(1);
}

}  // namespace wend::bench

int main(int argc, char** argv) {
  int rounds = 20;
  CLI::App app("Times smoothing, simplifying and following of paths on large maps, in CPU time.");
  app.add_option("--rounds", rounds, "timed runs of everything; the fastest counts")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  return wend::bench::parse_and_run(app, argc, argv, [&] {
    wend::bench::stay_on_one_core();
    return wend::bench::run(rounds) ? 0 : 1;
  });
}
