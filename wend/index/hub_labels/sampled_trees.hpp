#pragma once

// SampledTrees: shortest-path trees from random cells to the corners of a map, without what the
// hubs chosen so far cover. They tell how many shortest ways pass a corner.
//
// A node weighs what hangs below it: for each corner there, the cells that may turn first at it. A
// corner's total is the weight of its nodes in all trees: about how many ways between cells it would
// cover as the next hub. (D. Delling, A. Goldberg, T. Pajor and R. Werneck, "Robust Distance Queries
// on Massive Networks", 2014, sample from the nodes of the graph; sampling cells, and weighing by
// cells, makes smaller labels.)

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/index/corner_frontier.hpp"
#include "wend/index/corner_graph.hpp"
#include "wend/index/first_corners.hpp"
#include "wend/index/hub_labels/hub_labelling.hpp"

namespace wend {

class SampledTrees {
 public:
  /// No tree yet. All three must outlive it.
  SampledTrees(const CornerGraph& graph, const AllFirstCorners& first,
               const HubLabelling& labelling);

  /// Nodes of all trees.
  std::size_t size() const { return alive_; }
  std::uint64_t total(std::uint32_t corner) const { return totals_[corner]; }

  /// Grows a tree from a random cell; calls grew(corner) for the corners whose total it raised. Says
  /// how many.
  template <class Grew>
  std::size_t grow(Grew&& grew) {
    const std::size_t begin = grow_nodes();
    for (std::size_t node = begin; node < nodes_.size(); ++node) grew(nodes_[node].corner);
    return nodes_.size() - begin;
  }

  /// Cuts off the nodes of a corner, with all below them.
  void cut(std::uint32_t corner);

 private:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  struct Node {
    std::uint32_t corner;
    std::uint32_t parent;
    std::uint32_t child = kNone;        // the first one
    std::uint32_t sibling = kNone;      // the next one
    std::uint32_t same_corner = kNone;  // the next node of the corner, in any tree
    std::uint32_t weight;               // 0 once it is cut off
  };

  std::size_t grow_nodes();
  void spread();
  void start_at(std::uint32_t corner, CornerCost cost);
  void reach(const CornerFrontier::Entry& entry);
  void link(std::uint32_t node);
  void drop_cut_nodes();

  const CornerGraph& graph_;
  const AllFirstCorners& first_;
  const HubLabelling& labelling_;
  Random random_{1};
  std::vector<Cell> cells_;                 // roots to choose from
  std::vector<std::uint32_t> cell_counts_;  // by corner: cells that may turn first there, and 1
  std::vector<Node> nodes_;                 // tree after tree, parents before their children
  std::size_t alive_ = 0;
  std::vector<std::uint32_t> first_nodes_;  // by corner
  std::vector<std::uint64_t> totals_;       // by corner

  // Of the tree that grows.
  std::vector<CornerCost> from_root_;  // by hub
  std::vector<std::uint32_t> hubs_;    // of the corners that the root's ways turn first at
  CornerFrontier frontier_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace wend
