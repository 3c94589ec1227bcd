#include "wend/index/euclidean_labels/taut_order.hpp"

#include <algorithm>

#include "wend/base/random.hpp"
#include "wend/index/euclidean_labels/taut_tree.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::size_t kFirstTrees = 40;
constexpr std::size_t kFewEdges = 8;        // a corner: then new trees grow
constexpr std::size_t kNodesPerCorner = 8;  // of those that are left
constexpr std::size_t kTreesBetweenHubs = 4;
constexpr std::uint64_t kTaken = UINT64_MAX;

class SampledTautTrees {
 public:
  explicit SampledTautTrees(const TautGraph& graph)
      : tree_(graph),
        corners_(static_cast<std::uint32_t>(graph.portals().corners().size())),
        first_(corners_, kNone),
        node_of_(corners_, kNone),
        totals_(corners_, 0),
        taken_(corners_, 0) {}

  std::size_t alive() const { return alive_; }
  std::uint64_t total(std::uint32_t corner) const { return totals_[corner]; }

  /// A tree from a random corner that has not been taken. Calls grew(corner) for its corners.
  template <class Grew>
  void grow(Grew&& grew) {
    const std::uint32_t root = random_root();
    if (root == kNone) return;
    if (nodes_.size() > 2 * alive_ + corners_) drop_dead_nodes();
    const std::size_t begin = nodes_.size();
    add(root, kNone);
    tree_.spread(root, [&](const TautTree::Reached& at) {
      if (taken_[at.corner] != 0) return false;
      add(at.corner, node_of_[tree_.before(at.edge)]);
      return true;
    });
    alive_ += nodes_.size() - begin;
    for (std::size_t i = nodes_.size(); i-- > begin;) {
      const Node& node = nodes_[i];
      totals_[node.corner] += node.weight;
      if (node.parent != kNone) nodes_[node.parent].weight += node.weight;
      link(static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = begin; i < nodes_.size(); ++i) grew(nodes_[i].corner);
  }

  /// Cuts off what lies behind a corner in all trees.
  void take(std::uint32_t corner) {
    taken_[corner] = 1;
    for (std::uint32_t root = first_[corner]; root != kNone; root = nodes_[root].same_corner) {
      const std::uint32_t weight = nodes_[root].weight;
      if (weight == 0) continue;
      for (std::uint32_t up = nodes_[root].parent; up != kNone; up = nodes_[up].parent) {
        nodes_[up].weight -= weight;
        totals_[nodes_[up].corner] -= weight;
      }
      cut(root);
    }
    first_[corner] = kNone;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Node {
    std::uint32_t corner;
    std::uint32_t parent;
    std::uint32_t child = kNone;        // the first one
    std::uint32_t sibling = kNone;      // the next one
    std::uint32_t same_corner = kNone;  // the next node of the corner, in any tree
    std::uint32_t weight = 1;           // 0 once it is cut off
  };

  std::uint32_t random_root() {
    constexpr int kTries = 64;
    for (int i = 0; corners_ > 0 && i < kTries; ++i) {
      const auto root = static_cast<std::uint32_t>(random_.below(corners_));
      if (taken_[root] == 0) return root;
    }
    return kNone;  // few are left
  }

  void add(std::uint32_t corner, std::uint32_t parent) {
    node_of_[corner] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.corner = corner, .parent = parent});
  }

  void link(std::uint32_t i) {
    Node& node = nodes_[i];
    node.same_corner = first_[node.corner];
    first_[node.corner] = i;
    if (node.parent == kNone) return;
    node.sibling = nodes_[node.parent].child;
    nodes_[node.parent].child = i;
  }

  void cut(std::uint32_t root) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
      Node& node = nodes_[stack_.back()];
      stack_.pop_back();
      totals_[node.corner] -= node.weight;
      node.weight = 0;
      --alive_;
      for (std::uint32_t child = node.child; child != kNone; child = nodes_[child].sibling) {
        if (nodes_[child].weight != 0) stack_.push_back(child);
      }
    }
  }

  /// A node that is alive has a parent that is.
  void drop_dead_nodes() {
    std::vector<std::uint32_t> place(nodes_.size(), kNone);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Node node = nodes_[i];
      if (node.weight == 0) continue;
      place[i] = static_cast<std::uint32_t>(kept);
      if (node.parent != kNone) node.parent = place[node.parent];
      node.child = node.sibling = node.same_corner = kNone;
      nodes_[kept++] = node;
    }
    nodes_.resize(kept);
    std::ranges::fill(first_, kNone);
    for (std::size_t i = kept; i-- > 0;) link(static_cast<std::uint32_t>(i));
  }

  TautTree tree_;
  std::uint32_t corners_;
  Random random_{1};
  std::vector<Node> nodes_;             // tree after tree, parents first
  std::vector<std::uint32_t> first_;    // node of each corner
  std::vector<std::uint32_t> node_of_;  // of each corner, in the tree that grows
  std::vector<std::uint64_t> totals_;   // of each corner: the weights of its nodes
  std::vector<std::uint8_t> taken_;
  std::vector<std::uint32_t> stack_;
  std::size_t alive_ = 0;
};

struct Candidate {
  std::uint64_t total;     // at least that of the corner
  std::uint64_t at_first;  // before any corner was taken
  std::uint32_t corner;

  friend bool operator<(const Candidate& a, const Candidate& b) {
    if (a.total != b.total) return a.total > b.total;
    return a.at_first != b.at_first ? a.at_first > b.at_first : a.corner < b.corner;
  }
};

}  // namespace

std::vector<std::uint32_t> taut_order(const TautGraph& graph, const IndexBuilding& building) {
  const auto corners = static_cast<std::uint32_t>(graph.portals().corners().size());
  const bool grows_new = graph.edges() < kFewEdges * corners;
  SampledTautTrees trees(graph);
  for (std::size_t i = 0; i < kFirstTrees && !building.cancelled(); ++i) {
    trees.grow([](std::uint32_t) {});
  }
  std::vector<std::uint64_t> at_first;
  std::vector<Candidate> queue;
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    at_first.push_back(trees.total(corner));
    queue.push_back({at_first.back(), at_first.back(), corner});
  }
  min_heap::make(queue);
  std::vector<std::uint64_t> queued = at_first;  // of each corner: its total in the queue
  const auto push = [&](std::uint32_t corner) {
    queued[corner] = trees.total(corner);
    min_heap::push(queue, {queued[corner], at_first[corner], corner});
  };
  std::vector<std::uint32_t> order;
  while (order.size() < corners && !building.cancelled()) {
    const Candidate best = min_heap::pop(queue);
    if (best.total != queued[best.corner]) continue;  // it was pushed again
    if (best.total != trees.total(best.corner)) {
      push(best.corner);
      continue;
    }
    queued[best.corner] = kTaken;
    order.push_back(best.corner);
    trees.take(best.corner);
    const std::size_t left = corners - order.size();
    for (std::size_t i = 0;
         grows_new && i < kTreesBetweenHubs && trees.alive() < kNodesPerCorner * left; ++i) {
      trees.grow([&](std::uint32_t corner) {
        if (trees.total(corner) > queued[corner]) push(corner);
      });
    }
  }
  return order;
}

}  // namespace wend
