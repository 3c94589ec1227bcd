#pragma once

// Contraction: makes the ContractionHierarchy of a graph.
//
// It repeatedly contracts the node that needs the fewest shortcuts for the arcs that it removes. A
// search around the node decides whether a shortcut is needed. It gives up early: then there is a
// shortcut too many, never one too few. The work is counted and limited; the nodes that are left at
// the limit are the core. So the time is bounded for every graph, and the hierarchy is the same on every
// platform.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/index/corner_hierarchy/contraction_hierarchy.hpp"
#include "wend/index/index_building.hpp"

namespace wend {

struct GraphArc {
  std::uint32_t tail = 0;
  std::uint32_t head = 0;
  HierarchyCost cost = 0;
};

struct ContractionEffort {
  std::uint32_t settled_to_rank = 30;      // nodes per search, when nodes are ranked
  std::uint32_t settled_to_contract = 60;  // nodes per search, when a node is contracted
  std::uint64_t work_per_node = 2000;      // arcs; the limit is this times the number of nodes
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
Expected<ContractedGraph, Error> contract(std::uint32_t nodes, std::span<const GraphArc> arcs,
                                          const ContractionEffort& effort,
                                          const IndexBuilding& building);

}  // namespace wend
