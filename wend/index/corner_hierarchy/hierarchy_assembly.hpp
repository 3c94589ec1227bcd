#pragma once

// The last step of a contraction: from the nodes in the order in which they were taken out, and the
// arcs that they had then, to the flat arrays of a ContractionHierarchy.

#include <cstdint>
#include <vector>

#include "wend/index/corner_hierarchy/graph_contraction.hpp"
#include "wend/index/corner_hierarchy/shrinking_graph.hpp"

namespace wend {

/// `order` has all nodes, those of the core last, from `core_begin` on. Nodes may change places in
/// it, so that those lie near each other whose arcs are put together to paths.
ContractedGraph assemble(const ShrinkingGraph& graph, std::vector<std::uint32_t> order,
                         std::uint32_t core_begin);

}  // namespace wend
