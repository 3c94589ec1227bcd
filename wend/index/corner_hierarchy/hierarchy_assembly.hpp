#pragma once

// ShrinkingGraph: a directed graph from which nodes are removed while shortcuts are added.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/index/corner_hierarchy/graph_contraction.hpp"
#include "wend/index/index_building.hpp"

namespace wend {

class ShrinkingGraph {
 public:
  static constexpr std::uint32_t kNoMiddle = static_cast<std::uint32_t>(-1);

  struct Arc {
    std::uint32_t node;  // at the other end
    HierarchyCost cost;
    std::uint32_t middle;  // the removed node that a shortcut replaces, else kNoMiddle
  };

  ShrinkingGraph(std::uint32_t nodes, std::span<const GraphArc> arcs,
                 const IndexBuilding& building = {})
      : leaving_(nodes), entering_(nodes) {
    for (const GraphArc& arc : arcs) {
      if (building.cancelled()) return;
      add(arc, kNoMiddle);
    }
  }

  /// The arcs of a node to and from remaining nodes; for a removed node, the arcs that it had at its
  /// removal.
  std::span<const Arc> leaving(std::uint32_t node) const { return leaving_[node]; }
  std::span<const Arc> entering(std::uint32_t node) const { return entering_[node]; }

  /// Keeps only the cheaper of two arcs between the same nodes.
  void add(const GraphArc& arc, std::uint32_t middle) {
    keep_cheaper(leaving_[arc.tail], {arc.head, arc.cost, middle});
    keep_cheaper(entering_[arc.head], {arc.tail, arc.cost, middle});
  }

  /// Removes a node from the lists of its neighbours.
  void detach(std::uint32_t node) {
    for (const Arc& arc : leaving_[node]) forget(entering_[arc.node], node);
    for (const Arc& arc : entering_[node]) forget(leaving_[arc.node], node);
  }

 private:
  static void keep_cheaper(std::vector<Arc>& arcs, const Arc& arc) {
    for (Arc& other : arcs) {
      if (other.node != arc.node) continue;
      if (arc.cost < other.cost) other = arc;
      return;
    }
    arcs.push_back(arc);
  }

  static void forget(std::vector<Arc>& arcs, std::uint32_t node) {
    for (Arc& arc : arcs) {
      if (arc.node != node) continue;
      arc = arcs.back();
      arcs.pop_back();
      return;
    }
  }

  std::vector<std::vector<Arc>> leaving_;
  std::vector<std::vector<Arc>> entering_;
};

// The last step of a contraction: makes the flat arrays of a ContractionHierarchy from the nodes in the
// order of their removal and the arcs that they had then.

/// `order` contains all nodes; those of the core come last, from `core_begin` on. It may be changed so
/// that nodes whose arcs form paths together lie near each other.
ContractedGraph assemble(const ShrinkingGraph& graph, std::vector<std::uint32_t> order,
                         std::uint32_t core_begin);

}  // namespace wend
