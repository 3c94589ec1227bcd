#pragma once

// Whether the costs of a map's paths fit into 32 bits.

#include <span>

#include "wend/index/corner_hierarchy/graph_contraction.hpp"
#include "wend/index/turns.hpp"

namespace wend {

/// False if no shortest path on the map costs 2^32 - 1 or more. In each connected component it measures
/// the paths from one cell: two of them are at least as long as any. O(turns and arcs, log turns).
bool paths_may_be_too_long(const Turns& turns, std::span<const GraphArc> arcs);

}  // namespace wend
