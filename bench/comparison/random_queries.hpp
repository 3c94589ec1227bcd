#pragma once

// Random queries that have a path, or most likely have one, for comparisons and benchmarks.

#include <cstdint>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

struct CellPair {
  Cell start;
  Cell goal;
};

/// Pairs of different cells that a path joins with any kind of moves. The start is any cell with a
/// free neighbour, the goal any cell of the same connected component. The same seed gives the same
/// pairs. Empty if the map has no such pair. O(cells + count).
std::vector<CellPair> random_pairs(const FreeSpace& space, std::uint64_t count, std::uint64_t seed);

/// Queries for the car: from a lattice vertex and a heading to another vertex and a heading. Both
/// vertices are free and connected if headings are ignored, so most queries have a path, but not all.
/// All lie on these corners of cells. The same seed gives the same queries. Empty if
/// the map has no such pair. O(cells + count).
std::vector<Query> random_drives(const FreeSpace& space, const PlaceGrid& places,
                                 std::uint64_t count, std::uint64_t seed);

}  // namespace wend
