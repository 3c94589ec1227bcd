#pragma once

// How the outcome of a search is told to users.

#include "wend/base/status.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// Of a search that has ended. An exhausted one has found that there is no way.
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
    case SearchOutcome::cost_overflow:
      return Status::unsupported_map;
    case SearchOutcome::exhausted:
    case SearchOutcome::running:
      break;
  }
  return Status::unreachable;
}

}  // namespace wend
