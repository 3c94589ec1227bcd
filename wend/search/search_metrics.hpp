#pragma once

// The list of what a search counts, for reports and front ends.

#include <array>

#include "wend/base/metric.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// The metrics of a search, each once.
constexpr auto metrics_of(const SearchMetrics& metrics) {
  const auto count = [](std::string_view name, std::string_view help, std::uint64_t value) {
    return Metric{name, MetricUnit::count, help, static_cast<double>(value)};
  };
  return std::array{
      count("expanded", "states taken from the frontier; the goal counts", metrics.expanded),
      count("generated", "states that were reached; the start counts", metrics.generated),
      count("max_frontier", "the most states that were open at the same time",
            metrics.max_frontier)};
}

}  // namespace wend
