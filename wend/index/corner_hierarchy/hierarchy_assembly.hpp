#pragma once

// ShrinkingGraph: a directed graph from which nodes are taken out while shortcuts are put in.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/index/corner_hierarchy/graph_contraction.hpp"

namespace wend {

class ShrinkingGraph {
 public:
  static constexpr std::uint32_t kNoMiddle = static_cast<std::uint32_t>(-1);

  struct Arc {
    std::uint32_t node;  // at the other end
    HierarchyCost cost;
    std::uint32_t middle;  // of a shortcut the node that was taken out, else kNoMiddle
  };

  ShrinkingGraph(std::uint32_t nodes, std::span<const GraphArc> arcs)
      : leaving_(nodes), entering_(nodes) {
    for (const GraphArc& arc : arcs) add(arc, kNoMiddle);
  }

  /// The arcs to and from nodes that are not taken out; of a node that is, those it had then.
  std::span<const Arc> leaving(std::uint32_t node) const { return leaving_[node]; }
  std::span<const Arc> entering(std::uint32_t node) const { return entering_[node]; }

  /// Of two arcs between the same nodes the cheaper one stays.
  void add(const GraphArc& arc, std::uint32_t middle) {
    keep_cheaper(leaving_[arc.tail], {arc.head, arc.cost, middle});
    keep_cheaper(entering_[arc.head], {arc.tail, arc.cost, middle});
  }

  /// Takes a node out: its neighbours forget it.
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

// The last step of a contraction: from the nodes in the order in which they were taken out, and the
// arcs that they had then, to the flat arrays of a ContractionHierarchy.

/// `order` has all nodes, those of the core last, from `core_begin` on. Nodes may change places in
/// it, so that those lie near each other whose arcs are put together to paths.
ContractedGraph assemble(const ShrinkingGraph& graph, std::vector<std::uint32_t> order,
                         std::uint32_t core_begin);

}  // namespace wend
