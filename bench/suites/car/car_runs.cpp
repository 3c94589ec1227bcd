#include "bench/suites/car/car_runs.hpp"

#include <algorithm>
#include <limits>

#include "bench/measure/measuring.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

/// Memory that a new planner takes for its first search, per generated state.
double bytes_a_state(const Yard& yard, const PlannerSpec& spec) {
  const auto planner = make_planner(spec.name, yard.space, spec.options);
  Plan plan;
  const double before = resident_bytes();
  (*planner)->plan(yard.drives.front(), plan);
  return (resident_bytes() - before) / static_cast<double>(plan.metrics.generated);
}

}  // namespace

CarTiming time_car(const Yard& yard, const PlannerSpec& spec, int rounds) {
  CarTiming timing{.planner = spec.text, .bytes_a_state = bytes_a_state(yard, spec)};
  const auto planner = make_planner(spec.name, yard.space, spec.options);
  Plan plan;
  for (const Query& drive : yard.drives) {
    double fastest = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
      const double begin = thread_cpu_seconds();
      const Status status = (*planner)->plan(drive, plan);
      fastest = std::min(fastest, thread_cpu_seconds() - begin);
      if (round == 0 && status != Status::found) ++timing.failed;
    }
    timing.seconds += fastest;
    timing.expanded += static_cast<double>(plan.metrics.expanded);
    timing.fuel += plan.cost;
    timing.length += plan.path.length();
  }
  timing.expanded_a_second = timing.expanded / timing.seconds;
  const auto drives = static_cast<double>(yard.drives.size());
  for (double* sum : {&timing.seconds, &timing.expanded, &timing.fuel, &timing.length}) {
    *sum /= drives;
  }
  return timing;
}

}  // namespace wend::bench
