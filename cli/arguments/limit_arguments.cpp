#include "cli/arguments/limit_arguments.hpp"

#include <chrono>

#include "cli/arguments/flags.hpp"
#include "cli/interrupt.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kLimitSeconds{0, 1e9, "s"};

}  // namespace

void LimitArguments::add_to(Parser& app) {
  add_count(app, "--limit-expansions", expansions, "Give up after so many expansions");
  add_number(app, "--limit-time", seconds, kLimitSeconds,
             "Give up after so many seconds of search (wall time); reading the map and making "
             "the planner do not count");
}

Limits LimitArguments::limits(ProgressBar& progress) const {
  Limits limits;
  limits.expansions = expansions;
  if (seconds) limits.seconds = *seconds;
  // A search reads the clock at its start and then after every so many expansions.
  limits.clock = [&progress, expanded = std::uint64_t{0}]() mutable {
    progress.update(expanded);
    expanded += Limits::kExpansionsBetweenClockReads;
    return steady_seconds();
  };
  limits.cancel = &Interruptible::cancelled();
  return limits;
}

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace wend::cli
