#pragma once

// What a search may use: --limit-expansions, --limit-time, and Ctrl-C.

#include <cstdint>
#include <optional>

#include "cli/arguments/parser.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/base/limits.hpp"

namespace wend::cli {

struct LimitArguments {
  std::uint64_t expansions = Limits::kUnlimited;
  std::optional<double> seconds;

  void add_to(Parser& app);

  /// `progress` is told the cells expanded; it must outlive the search. Within an Interruptible,
  /// Ctrl-C cancels the search.
  Limits limits(ProgressBar& progress) const;
};

/// Seconds of a clock that never goes back.
double steady_seconds();

}  // namespace wend::cli
