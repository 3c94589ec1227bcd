#pragma once

// Random queries that have a path, or most likely have one: what comparisons and benchmarks ask.

#include <cstdint>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/map/free_space.hpp"
#include "wend/planner/plan.hpp"

namespace wend {

struct CellPair {
  Cell start;
  Cell goal;
};

/// Pairs of different cells that a path joins whatever the moves: the start is any cell that can be
/// left, the goal any that can be reached from it. The same seed gives the same pairs. Empty where
/// there is no such pair. O(cells + count).
std::vector<CellPair> random_pairs(const FreeSpace& space, std::uint64_t count, std::uint64_t seed);

/// Queries of a car, from a corner and heading to another corner and a heading. It can stand on
/// both, and moves could join them if headings did not matter: most have a path, but not all. The
/// coordinates are multiples of `unit`, 1 or more. The same seed gives the same queries. Empty where
/// there is no such pair. O(cells + count).
std::vector<Query> random_drives(const FreeSpace& space, int unit, std::uint64_t count,
                                 std::uint64_t seed);

}  // namespace wend
