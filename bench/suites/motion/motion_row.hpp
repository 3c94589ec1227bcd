#pragma once

// How long one thing takes.

#include <algorithm>
#include <string>
#include <vector>

#include "wend/base/thread_time.hpp"

namespace wend::bench {

struct MotionRow {
  std::string name;
  double seconds = 0;      // of CPU time; the fastest of several rounds
  double bar_seconds = 0;  // must stay below it; 0: no bar
  std::string note;        // what was done in that time
};

/// The CPU seconds of the fastest of several rounds.
template <class Run>
double fastest(int rounds, Run&& run) {
  double best = 1e9;
  for (int i = 0; i < rounds; ++i) {
    best = std::min(best, seconds_of(thread_cpu_seconds, run));
  }
  return best;
}

/// Smoothing and simplifying paths of 1000 points on maps of 2000 x 2000 cells.
std::vector<MotionRow> smoothing_rows(int rounds);

/// Following a path through an office with every controller: a control step, and a simulated minute.
std::vector<MotionRow> following_rows(int rounds);

}  // namespace wend::bench
