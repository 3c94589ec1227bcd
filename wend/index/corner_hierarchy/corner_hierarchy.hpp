#pragma once

// The index of the planner corner_hierarchy: the turns of a map, contracted.
//
// A query starts at the turns that a path from its start may reach first, and ends at those that a
// path to its goal may pass last; in between it climbs the hierarchy from both sides, guided by
// the octile distance. See turns.hpp for why that is a shortest path, contraction_hierarchy.hpp for
// the climbing. The file contains the hierarchy; opening it computes the turns again, which takes a
// few milliseconds.
//
// Costs are 32-bit: maps on which a path may cost more than 2^32 - 1, about 128,000 cells, are rejected.

#include <memory>
#include <span>
#include <string>

#include "wend/base/error.hpp"
#include "wend/index/corner_hierarchy/graph_contraction.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/index/index_engine.hpp"
#include "wend/index/turns.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

/// Fails if it is cancelled or if paths may be too long.
Expected<IndexBytes, Error> build_corner_hierarchy(const BitGrid& passable,
                                                   const IndexBuilding& building,
                                                   const ContractionEffort& effort = {});

/// An engine for an index of these cells, or what is wrong with the index.
Expected<std::unique_ptr<IndexEngine>, Error> open_corner_hierarchy(IndexBytes index,
                                                                    const BitGrid& passable);

/// False if no shortest path on the map costs 2^32 - 1 or more. In each connected component it measures
/// the paths from one cell: two of them are at least as long as any. O(turns and arcs, log turns).
bool paths_may_be_too_long(const Turns& turns, std::span<const GraphArc> arcs);

}  // namespace wend
