#pragma once

// The state of a search, its work, and the Status of its end.

#include <cstdint>

#include "wend/base/status.hpp"

namespace wend {

/// The state of a search.
enum class SearchOutcome {
  running,          // it has not ended
  improved,         // the same, and an anytime search has a better path or bound
  found,            // it reached a goal
  exhausted,        // every state that can be reached was expanded
  expansion_limit,  // Limits::expansions was reached
  time_limit,       // Limits::seconds passed
  cancelled,        // Limits::cancel was set
  cost_overflow,    // costs exceeded their type: search again with a larger one
  out_of_memory,    // no memory for the nodes
  step_limit,       // a walk used up its steps
};

/// The work of one search.
struct SearchMetrics {
  std::uint64_t expanded = 0;      // states taken from the frontier; the goal counts
  std::uint64_t generated = 0;     // states that were reached for the first time; the start counts
  std::uint64_t max_frontier = 0;  // the most states that were generated and not yet expanded

  friend bool operator==(const SearchMetrics&, const SearchMetrics&) = default;
};

/// The status of a search that has ended. `exhausted` becomes `unreachable`.
constexpr Status status_of(SearchOutcome outcome) {
  switch (outcome) {
    case SearchOutcome::found:
      return Status::found;
    case SearchOutcome::expansion_limit:
      return Status::expansion_limit;
    case SearchOutcome::time_limit:
      return Status::time_limit;
    case SearchOutcome::cancelled:
      return Status::cancelled;
    case SearchOutcome::out_of_memory:
      return Status::memory_limit;
    case SearchOutcome::step_limit:
      return Status::step_limit;
    case SearchOutcome::cost_overflow:
      return Status::unsupported_map;
    case SearchOutcome::exhausted:
    case SearchOutcome::running:
    case SearchOutcome::improved:
      break;
  }
  return Status::unreachable;
}

}  // namespace wend
