#pragma once

// Dubins and Reeds-Shepp curves: ours beside OMPL's, in the same run.

#include <string>

namespace wend::bench {

struct CurveTable {
  std::string text;         // markdown: nanoseconds a call
  std::string differences;  // lengths that differ by more than 1e-6 radii; empty if none do
};

/// Times `count` random pairs of poses in squares of several sizes, each `rounds` times; the fastest run counts.
/// Without OMPL, its columns are empty.
CurveTable curve_table(int count, int rounds);

}  // namespace wend::bench
