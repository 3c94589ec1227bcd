#pragma once

// The order in which corners become hubs of a TautLabelling: the corner first that lies on most taut paths that no
// earlier one covers, as sampled trees estimate. The same in every run.
//
// The trees grow from random corners. The weight of a corner is the number of nodes behind it in all trees; when it
// is taken, these are cut off. On maps whose corners see few others, such as mazes, the first trees say too little of
// what comes late; there new trees grow, as far as corners that have been taken, while old ones become small.

#include <cstdint>
#include <vector>

#include "wend/index/index_building.hpp"
#include "wend/sight/taut_graph.hpp"

namespace wend {

/// All corners of a graph, or only some if the building is cancelled. All edges must be known. O(edges log corners) for
/// each of some forty trees.
std::vector<std::uint32_t> taut_order(const TautGraph& graph, const IndexBuilding& building);

}  // namespace wend
