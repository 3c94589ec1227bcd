#pragma once

// Contraction: makes the ContractionHierarchy of a graph.
//
// Again and again the node is taken out that costs the least shortcuts for the arcs that it frees.
// Whether a shortcut is needed is asked of a search around the node, which gives up early: then
// there is a shortcut too many, never one too few. All work is counted, and when it is spent the
// nodes that are left are the core. So the time it takes is bounded, whatever the graph; and it is
// the same hierarchy on every platform.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/index/corner_hierarchy/contraction_hierarchy.hpp"
#include "wend/index/index_building.hpp"

namespace wend {

struct GraphArc {
  std::uint32_t tail = 0;
  std::uint32_t head = 0;
  HierarchyCost cost = 0;
};

struct ContractionEffort {
  std::uint32_t settled_to_rank = 30;      // nodes, by a search, while it is seen who is next
  std::uint32_t settled_to_contract = 60;  // nodes, by a search, when a node is taken out
  std::uint64_t work_per_node = 2000;      // arcs looked at; in all, as often as there are nodes
};

/// A hierarchy with its arrays.
struct ContractedGraph {
  std::vector<std::uint32_t> heights;  // by node of the graph: its number in the hierarchy
  std::vector<HierarchyNode> nodes;
  std::vector<HierarchyArc> arcs;
  std::vector<HierarchyVia> vias;
  std::uint32_t core_begin = 0;

  ContractionHierarchy hierarchy() const { return {nodes, arcs, vias, core_begin}; }
};

/// Arcs have positive costs and no arc joins a node with itself; shortest paths cost less than 2^32.
/// Fails only if it is cancelled.
Expected<ContractedGraph, IndexError> contract(std::uint32_t nodes, std::span<const GraphArc> arcs,
                                               const ContractionEffort& effort,
                                               const IndexBuilding& building);

}  // namespace wend
