#include "cli/arguments/search_arguments.hpp"

#include <chrono>
#include <cstdint>

#include "cli/arguments/flags.hpp"
#include "cli/interrupt.hpp"

namespace wend::cli {

void MovesArguments::add_to(Parser& app) {
  add_choice<Connectivity>(app, "--connectivity", moves.connectivity, named_values<Connectivity>(),
                           "Number of neighbours of a cell: 4 or 8 (default 8)");
  add_choice<CornerRule>(app, "--corner-rule", moves.corner_rule, named_values<CornerRule>(),
                         "Corners that a diagonal step may cut (default none)");
}

void add_corner_rule(Parser& app, CornerRule& rule) {
  add_choice<CornerRule>(
      app, "--corner-rule", rule, named_values<CornerRule>(),
      "Corner rule that the path was planned with: with both, a robot with radius 0 may pass "
      "between two obstacles that touch at a corner (default none)");
}

Limits LimitArguments::limits() const {
  Limits limits;
  fields_.put(limits);
  limits.cancel = &Interruptible::cancelled();
  return limits;
}

Limits LimitArguments::limits(ProgressBar& progress) const {
  Limits limits = this->limits();
  // A search reads the clock at its start, then every kExpansionsBetweenClockReads expansions.
  limits.clock = [&progress, expanded = std::uint64_t{0}]() mutable {
    progress.update(expanded);
    expanded += Limits::kExpansionsBetweenClockReads;
    return steady_seconds();
  };
  return limits;
}

Deadline LimitArguments::deadline() const { return Deadline(limits()); }

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace wend::cli
