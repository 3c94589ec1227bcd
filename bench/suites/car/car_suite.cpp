// Our car on large yards, with each of its heuristics, beside OMPL's Reeds-Shepp
// planners.

#include <fmt/format.h>

#include "bench/measure/measuring.hpp"
#include "bench/suites/car/car_runs.hpp"
#include "bench/suites/car/reeds_shepp.hpp"
#include "bench/suites/suite.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

struct CarSpeedPlan {
  YardPlan yards;
  std::string planners =
      "car,car:heuristic=zero,car:heuristic=diagonal,car:heuristic=obstacles,car:weight=1.5";
  int rounds = 3;
  double ompl_seconds = 10;
};

void print(const CarTiming& timing) {
  fmt::print(
      "  {:<26} {:>9.1f} ms {:>10.0f} expanded {:>6.2f} M/s {:>5.1f} bytes a state  fuel "
      "{:.2f}, length {:.2f}{}\n",
      timing.planner, timing.seconds * 1e3, timing.expanded, timing.expanded_a_second / 1e6,
      timing.bytes_a_state, timing.fuel, timing.length,
      timing.failed == 0 ? "" : fmt::format("  {} FAILED", timing.failed));
}

void print(const ReedsSheppTiming& timing, const CarTiming& car) {
  if (timing.solved == 0) {
    fmt::print("  OMPL {:<21} none of {} drives solved\n", timing.planner, timing.drives);
    return;
  }
  fmt::print(
      "  OMPL {:<21} {:>9.1f} ms to the first solution, {} of {} solved, length {:.2f}; "
      "{:.2g} times the time of {}\n",
      timing.planner, timing.seconds * 1e3, timing.solved, timing.drives, timing.length,
      timing.seconds / car.seconds, car.planner);
}

/// Says whether every drive was found.
bool run(const CarSpeedPlan& plan, const std::vector<PlannerSpec>& planners) {
  bool all_found = true;
  prepare_reeds_shepp(1);
  for (const Yard& yard : make_yards(plan.yards)) {
    fmt::print("{}: {} x {} cells, {} drives\n", yard.name, yard.space.width(), yard.space.height(),
               yard.drives.size());
    std::vector<CarTiming> timings;
    for (const PlannerSpec& spec : planners) {
      timings.push_back(time_car(yard, spec, plan.rounds));
      print(timings.back());
      all_found = all_found && timings.back().failed == 0;
    }
    if (plan.ompl_seconds <= 0) continue;
    for (const std::string& planner : reeds_shepp_planners()) {
      print(time_reeds_shepp(yard, planner, plan.ompl_seconds), timings.front());
    }
  }
  return all_found;
}

}  // namespace

Measure add_car(CLI::App& app) {
  const auto plan = std::make_shared<CarSpeedPlan>();
  app.add_option("--size", plan->yards.size, "cells along each side of the yards")
      ->check(CLI::Range(20, kMostGeneratedCells))
      ->capture_default_str();
  app.add_option("--drives", plan->yards.drives, "drives on each yard, the first corner to corner")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--seed", plan->yards.seed, "of yards and drives")->capture_default_str();
  app.add_option("--planner", plan->planners, "a list, as car,car:heuristic=zero")
      ->capture_default_str();
  add_rounds(app, plan->rounds);
  app.add_option("--ompl-seconds", plan->ompl_seconds,
                 "how long each of OMPL's planners may search for a drive; 0: leave them out")
      ->check(CLI::Range(0, 3600))
      ->capture_default_str();
  return [plan] {
    const auto specs = value_or_refuse(parse_planner_specs(plan->planners));
    for (const PlannerSpec& spec : specs) {
      if (planners().find(spec.name)->capabilities.vertices == Vertices::corners) continue;
      throw Refused("--planner: " + spec.name + " drives no car");
    }
    stay_on_one_core();
    return run(*plan, specs) ? 0 : 1;
  };
}

}  // namespace wend::bench
