#pragma once

// What limits a search: the moves of the robot (--connectivity, --corner-rule) where no planner has them
// among its options, and --limit-expansions and --limit-time.

#include "cli/arguments/parser.hpp"
#include "cli/arguments/request_arguments.hpp"
#include "cli/output/progress_bar.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/limits.hpp"
#include "wend/planner/planners.hpp"

namespace wend::cli {

/// --connectivity and --corner-rule.
struct MovesArguments {
  GridMoves moves;

  void add_to(Parser& app);
};

/// --corner-rule none|one|both
void add_corner_rule(Parser& app, CornerRule& rule);

/// --limit-expansions and --limit-time.
class LimitArguments {
 public:
  void add_to(Parser& app) { fields_.add_limits_to(app); }

  /// `progress` is told the cells expanded; it must outlive the search. Within an Interruptible,
  /// Ctrl-C cancels the search.
  Limits limits(ProgressBar& progress) const;

  /// The same without progress.
  Limits limits() const;

  /// The limit on time and Ctrl-C, for all that a query takes; the time begins.
  Deadline deadline() const;

 private:
  RequestArguments fields_;
};

/// Seconds of a monotonic clock.
double steady_seconds();

}  // namespace wend::cli
