#pragma once

// OMPL's planners for a car with a turning radius of one cell, on the same yards: what a user would
// pick otherwise. They drive Reeds-Shepp curves, anywhere and with any heading.
//
// A state is valid if its point is not in an obstacle cell. Our car has the harder task: it avoids
// every vertex that an obstacle touches.

#include <cstdint>
#include <string>
#include <vector>

#include "bench/suites/car/yard.hpp"

namespace wend::bench {

/// Time to the first solution. Means over the solved drives.
struct ReedsSheppTiming {
  std::string planner;
  double seconds = 0;
  double length = 0;  // cells
  std::size_t solved = 0;
  std::size_t drives = 0;
};

/// Call once, first: seeds OMPL's random numbers and silences all messages except errors.
void prepare_reeds_shepp(std::uint32_t seed);

/// "RRTConnect", "RRT", "KPIECE1"
std::vector<std::string> reeds_shepp_planners();

/// Gives up on a query after `seconds`.
ReedsSheppTiming time_reeds_shepp(const Yard& yard, const std::string& planner, double seconds);

}  // namespace wend::bench
