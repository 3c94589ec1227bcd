#pragma once

// BenchAnswer: what a planner answered to a query of a scenario, and how long that took. Times are
// CPU time of the thread (wend/base/thread_time.hpp).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/status.hpp"

namespace wend {

/// One run of a query with a new planner.
struct FirstQuery {
  double prepare_s = 0;  // seconds to make the planner, without its index
  double seconds = 0;    // of the query
};

/// When a better path was there.
struct BenchSolution {
  double seconds = 0;  // since the search began
  double cost = 0;     // of the best path by then, as BenchAnswer::length

  friend bool operator==(const BenchSolution&, const BenchSolution&) = default;
};

struct BenchAnswer {
  std::size_t line = 0;  // of the query in the scenario's file: identifies the query
  Status status = Status::found;
  double length = 0;  // of the path, in cells, or its cost on terrain; 0 without one
  std::uint64_t expanded = 0;
  bool wrong = false;
  std::vector<double> seconds{};      // of every repetition; planners repeat their answers
  std::optional<FirstQuery> first{};  // if it was measured
  // The paths of an anytime planner, in order, from a separate run.
  std::vector<BenchSolution> progress{};

  bool found() const { return status == Status::found; }

  /// For an answer with at least one repetition.
  double fastest() const { return *std::min_element(seconds.begin(), seconds.end()); }
};

/// What a planner answered on one map.
struct BenchedMap {
  std::string planner;
  std::uint64_t free_cells = 0;
  std::vector<BenchAnswer> answers{};  // each with at least one repetition
  std::string scen{};
};

}  // namespace wend
