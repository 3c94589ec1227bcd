#pragma once

// chord_counts: how many chords each of several arcs gets, so that they keep within a tolerance, and that no
// tolerance makes more than kMostPosesAlong of them.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "wend/geometry/arc.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// chord_count() of each arc; where that is more than kMostPosesAlong together, each gets fewer by the same factor,
/// and at least 1.
inline std::vector<int> chord_counts(std::span<const Arc> arcs, double tolerance) {
  std::vector<int> counts;
  counts.reserve(arcs.size());
  for (const Arc& arc : arcs) counts.push_back(chord_count(arc, tolerance));
  const std::int64_t sum = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  constexpr auto kMost = static_cast<std::int64_t>(kMostPosesAlong);
  if (sum <= kMost) return counts;
  for (int& count : counts) count = std::max(1, static_cast<int>(count * kMost / sum));
  return counts;
}

}  // namespace wend
