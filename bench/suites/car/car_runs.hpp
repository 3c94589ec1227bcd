#pragma once

// Times our car on a yard.

#include <string>
#include <vector>

#include "bench/suites/car/yard.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {

/// Means over the drives of a yard.
struct CarTiming {
  std::string planner;
  double seconds = 0;  // the fastest of the rounds
  double expanded = 0;
  double expanded_a_second = 0;  // over all drives together
  double bytes_a_state = 0;      // of memory touched by the drive from corner to corner
  double fuel = 0;
  double length = 0;
  std::size_t failed = 0;
};

CarTiming time_car(const Yard& yard, const PlannerSpec& planner, int rounds);

}  // namespace wend::bench
