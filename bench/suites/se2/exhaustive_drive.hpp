#pragma once

// Is there a drive at all? A breadth-first search over poses for queries that a planner has not solved: without
// heuristic and without costs, by the check's own code for collisions.

#include <cstdint>

#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {

struct ExhaustiveAnswer {
  bool found = false;        // if not, there may still be a drive between finer poses
  std::uint64_t states = 0;  // expanded
};

/// Drives lines and arcs of `radius` cells in both gears, to one pose for each half cell and 5 degrees. Ends with
/// the first collision-free Reeds-Shepp curve to the goal. Takes seconds to minutes, and a bit for each pose.
ExhaustiveAnswer exhaustive_drive(const FreeSpace& space, const Query& query, double radius);

}  // namespace wend::bench
