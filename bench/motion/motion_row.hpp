#pragma once

// What wend-motion-speed prints: how long one thing takes.

#include <string>
#include <vector>

namespace wend::bench {

struct MotionRow {
  std::string name;
  double seconds = 0;      // the fastest of several rounds
  double bar_seconds = 0;  // what it must stay below; 0: nothing
  std::string note;        // what was done in that time
};

/// Smoothing and simplifying paths of 1000 points on maps of 2000 x 2000 cells.
std::vector<MotionRow> smoothing_rows(int rounds);

}  // namespace wend::bench
