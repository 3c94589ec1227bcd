#pragma once

// SearchMetrics: the work of one search.

#include <cstdint>

namespace wend {

struct SearchMetrics {
  std::uint64_t expanded = 0;      // states taken from the frontier; the goal counts
  std::uint64_t generated = 0;     // states that were reached for the first time; the start counts
  std::uint64_t max_frontier = 0;  // the most states that were generated and not yet expanded

  friend bool operator==(const SearchMetrics&, const SearchMetrics&) = default;
};

}  // namespace wend
