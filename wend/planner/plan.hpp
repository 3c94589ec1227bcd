#pragma once

// Plan: what a planner found. PlanFailure: why it found nothing.

#include <limits>
#include <string>
#include <vector>

#include "wend/base/status.hpp"
#include "wend/path/path.hpp"
#include "wend/search/search_metrics.hpp"

namespace wend {

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
