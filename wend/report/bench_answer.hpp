#pragma once

// BenchAnswer: what a planner answered to a query of a scenario, and how long that took.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/base/status.hpp"

namespace wend {

struct BenchAnswer {
  std::size_t line = 0;  // of the query in the scenario's file: tells the queries apart
  Status status = Status::found;
  double length = 0;  // of the path, in cells; 0 without one
  std::uint64_t expanded = 0;
  bool wrong = false;
  std::vector<double> seconds{};  // of every pass; planners answer the same again

  bool found() const { return status == Status::found; }

  /// Of an answer with a pass at least.
  double fastest() const { return *std::min_element(seconds.begin(), seconds.end()); }
};

}  // namespace wend
