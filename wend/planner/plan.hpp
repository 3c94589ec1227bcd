#pragma once

// Plan: what a planner found. PlanFailure: why it found nothing.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "wend/base/status.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// The work of one search.
struct SearchMetrics {
  std::uint64_t expanded = 0;      // states whose successors were made; the goal counts
  std::uint64_t generated = 0;     // states that were reached for the first time; the start counts
  std::uint64_t max_frontier = 0;  // the most states that were generated and not yet expanded

  friend bool operator==(const SearchMetrics&, const SearchMetrics&) = default;
};

struct Plan {
  /// What `bound` says where nothing is promised about the cost.
  static constexpr double kNoBound = std::numeric_limits<double>::infinity();

  Path path;
  double cost = 0;                 // recomputed from the path by its space
  double bound = kNoBound;         // cost <= bound * the cheapest cost; 1: optimal
  std::vector<std::string> moves;  // where the planner's space has named moves, else empty
  SearchMetrics metrics;

  bool optimal() const { return bound == 1; }
};

struct PlanFailure {
  Status status;          // never Status::found
  SearchMetrics metrics;  // of the search until then
};

}  // namespace wend
