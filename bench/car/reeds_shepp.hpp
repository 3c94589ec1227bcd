#pragma once

// OMPL's planners for a car with a turning radius of one cell, on the same yards: what a user would
// pick otherwise. They drive Reeds-Shepp curves, anywhere and with any heading.
//
// A state is valid where its point lies in no obstacle cell: our car, which stays off every corner
// that an obstacle touches, has the harder task.

#include <cstdint>
#include <string>
#include <vector>

#include "bench/car/yard.hpp"

namespace wend::bench {

/// To the first solution. Means over the drives that were solved.
struct ReedsSheppTiming {
  std::string planner;
  double seconds = 0;
  double length = 0;  // cells
  std::size_t solved = 0;
  std::size_t drives = 0;
};

/// Once, before all others: OMPL's random numbers, and no messages but of errors.
void prepare_reeds_shepp(std::uint32_t seed);

/// "RRTConnect", "RRT", "KPIECE1"
std::vector<std::string> reeds_shepp_planners();

/// Gives up on a query after `seconds`.
ReedsSheppTiming time_reeds_shepp(const Yard& yard, const std::string& planner, double seconds);

}  // namespace wend::bench
