#pragma once

// SampledForest: shortest-path trees over the corners of a map, from random roots, while an index takes corner after
// corner as a hub. They estimate how many shortest paths pass a corner that no hub covers yet: the total of a corner is
// the weight of the subtrees of its nodes. Taking a corner cuts these off. (D. Delling, A. Goldberg, T. Pajor and
// R. Werneck, "Robust Distance Queries on Massive Networks", 2014.)

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wend {

class SampledForest {
 public:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// Has no trees yet.
  explicit SampledForest(std::size_t corners) : first_nodes_(corners, kNone), totals_(corners) {}

  /// The number of nodes that are not cut off.
  std::size_t size() const { return alive_; }
  std::uint64_t total(std::uint32_t corner) const { return totals_[corner]; }

  /// Begins a tree. It forgets the nodes that were cut off if they are most of all. O(1) amortized.
  void begin_tree();
  /// Adds a node with a weight above 0 to the tree, parents before their children; a root has kNone for its parent.
  /// Returns its number, which counts until the next tree begins.
  std::uint32_t add(std::uint32_t corner, std::uint32_t parent, std::uint32_t weight);
  /// Ends the tree: its nodes count from now on. Calls grew(corner) for each and returns their number.
  template <class Grew>
  std::size_t end_tree(Grew&& grew) {
    sum_weights();
    for (std::size_t i = begin_; i < nodes_.size(); ++i) grew(nodes_[i].corner);
    return nodes_.size() - begin_;
  }

  /// Cuts off the subtrees of all nodes of a corner.
  void cut(std::uint32_t corner);

 private:
  struct Node {
    std::uint32_t corner;
    std::uint32_t parent;
    std::uint32_t child = kNone;        // the first one
    std::uint32_t sibling = kNone;      // the next one
    std::uint32_t same_corner = kNone;  // the next node of the corner, in any tree
    std::uint32_t weight;               // of its subtree; 0 once it is cut off
  };

  void sum_weights();
  void link(std::uint32_t node);
  void cut_subtree(std::uint32_t root);
  void drop_cut_nodes();

  std::vector<Node> nodes_;                 // tree after tree, parents before their children
  std::vector<std::uint32_t> first_nodes_;  // by corner
  std::vector<std::uint64_t> totals_;       // by corner
  std::vector<std::uint32_t> stack_;
  std::size_t begin_ = 0;  // of the tree that grows
  std::size_t alive_ = 0;
};

}  // namespace wend
