#pragma once

// WitnessSearch: which shortcuts a graph needs if a node is taken out: those between two neighbours
// for which no way around the node was found that is as short as the way through it.

#include <cstdint>
#include <vector>

#include "wend/index/corner_hierarchy/graph_contraction.hpp"
#include "wend/index/corner_hierarchy/shrinking_graph.hpp"

namespace wend {

class WitnessSearch {
 public:
  explicit WitnessSearch(std::uint32_t nodes) : labels_(nodes) {}

  /// Replaces `shortcuts` by what is needed without the node. From each neighbour, a search settles
  /// at most so many nodes.
  void find_shortcuts(const ShrinkingGraph& graph, std::uint32_t node, std::uint32_t most_settled,
                      std::vector<GraphArc>& shortcuts);

  /// Arcs looked at until now, and what else takes time.
  std::uint64_t work() const { return work_; }

 private:
  struct Label {
    HierarchyCost cost = 0;
    std::uint32_t search = 0;  // the cost is of this search
    std::uint32_t target = 0;  // it is a target of this search
  };

  std::uint32_t mark_targets(const ShrinkingGraph& graph, std::uint32_t node, std::uint32_t tail);
  void search(const ShrinkingGraph& graph, std::uint32_t without, std::uint32_t from,
              std::uint64_t farthest, std::uint32_t targets, std::uint32_t most_settled);

  std::vector<Label> labels_;
  std::vector<std::uint64_t> queue_;  // cost, then node
  std::uint32_t search_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace wend
