#include "wend/index/hub_labels/label_order.hpp"

#include <algorithm>

#include "wend/base/random.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::size_t kFirstTrees = 16;
constexpr std::size_t kNodesPerCorner = 16;
constexpr double kFewNodes = 20;        // per tree
constexpr double kMemoryOfMean = 0.99;  // of the running mean

}  // namespace

// SampledTrees: shortest-path trees from random cells to the corners of a map, without what the hubs
// chosen so far cover. They estimate how many shortest paths pass a corner.
//
// The weight of a node counts, for each corner in its subtree, the cells that may turn first at it. The
// total of a corner is the weight of its nodes in all trees: roughly the number of paths between cells
// that it would cover as the next hub. (D. Delling, A. Goldberg, T. Pajor and R. Werneck, "Robust
// Distance Queries on Massive Networks", 2014, sample from the nodes of the graph; sampling cells, and
// weighing by cells, makes smaller labels.)

class SampledTrees {
 public:
  /// Has no trees yet. All three must outlive it.
  SampledTrees(const CornerGraph& graph, const AllFirstCorners& first,
               const HubLabelling& labelling, const IndexBuilding& building)
      : graph_(graph),
        first_(first),
        labelling_(labelling),
        building_(building),
        cell_counts_(graph.size(), 1),
        first_nodes_(graph.size(), kNone),
        totals_(graph.size()),
        from_root_(graph.size(), kUnreachedCost),
        frontier_(graph.size()) {
    for (const Cell cell : every_cell(graph.corners().passable())) {
      const auto list = first.of(cell);
      if (!list.empty()) cells_.push_back(cell);
      for (const std::uint32_t corner : list) ++cell_counts_[corner];
    }
  }

  /// The number of nodes in all trees.
  std::size_t size() const { return alive_; }
  std::uint64_t total(std::uint32_t corner) const { return totals_[corner]; }

  /// Grows a tree from a random cell; calls grew(corner) for the corners whose total it raised. Returns
  /// their number.
  template <class Grew>
  std::size_t grow(Grew&& grew) {
    const std::size_t begin = grow_nodes();
    for (std::size_t node = begin; node < nodes_.size(); ++node) grew(nodes_[node].corner);
    return nodes_.size() - begin;
  }

  /// Cuts off the subtrees of all nodes of a corner.
  void cut(std::uint32_t corner) {
    for (std::uint32_t root = first_nodes_[corner]; root != kNone;
         root = nodes_[root].same_corner) {
      const std::uint32_t weight = nodes_[root].weight;
      if (weight == 0) continue;
      for (std::uint32_t up = nodes_[root].parent; up != kNone; up = nodes_[up].parent) {
        nodes_[up].weight -= weight;
        totals_[nodes_[up].corner] -= weight;
      }
      stack_.push_back(root);
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
    first_nodes_[corner] = kNone;
  }

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

  std::size_t grow_nodes() {
    if (nodes_.size() > 2 * alive_ + graph_.size()) drop_cut_nodes();
    const std::size_t begin = nodes_.size();
    if (cells_.empty()) return begin;
    const Corners& corners = graph_.corners();
    const Cell root = cells_[random_.below(cells_.size())];
    if (corners.contains(root)) {
      start_at(corners.number(root), 0);
    } else {
      for (const std::uint32_t corner : first_.of(root)) {
        start_at(corner, octile_cost<CornerCost>(root, corners.cell(corner)));
      }
    }
    spread();
    frontier_.clear();
    for (const std::uint32_t hub : hubs_) from_root_[hub] = kUnreachedCost;
    hubs_.clear();

    alive_ += nodes_.size() - begin;
    for (std::size_t i = nodes_.size(); i-- > begin;) {
      const Node& node = nodes_[i];
      totals_[node.corner] += node.weight;
      if (node.parent != kNone) nodes_[node.parent].weight += node.weight;
      link(static_cast<std::uint32_t>(i));
    }
    return begin;
  }

  void spread() {
    while (!frontier_.empty() && !building_.cancelled()) {
      const CornerFrontier::Entry next = frontier_.pop();
      if (frontier_.is_outdated(next)) continue;
      if (covers(labelling_.label(next.corner), from_root_, next.cost)) continue;
      const auto place = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(
          {.corner = next.corner, .parent = next.parent, .weight = cell_counts_[next.corner]});
      for (const CornerEdge edge : graph_.edges(next.corner)) {
        reach({next.cost + edge.cost, edge.to, place});
      }
    }
  }

  void start_at(std::uint32_t corner, CornerCost cost) {
    for (const HubEntry& entry : labelling_.label(corner)) {
      CornerCost& from_root = from_root_[entry.hub];
      if (from_root == kUnreachedCost) hubs_.push_back(entry.hub);
      from_root = std::min(from_root, cost + entry.cost);
    }
    reach({cost, corner, kNone});
  }

  void reach(const CornerFrontier::Entry& entry) {
    if (!labelling_.is_hub(entry.corner)) frontier_.reach(entry);
  }

  void link(std::uint32_t node) {
    Node& linked = nodes_[node];
    linked.same_corner = first_nodes_[linked.corner];
    first_nodes_[linked.corner] = node;
    if (linked.parent == kNone) return;
    linked.sibling = nodes_[linked.parent].child;
    nodes_[linked.parent].child = node;
  }

  void drop_cut_nodes() {
    std::vector<std::uint32_t> places(nodes_.size());
    std::fill(first_nodes_.begin(), first_nodes_.end(), kNone);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Node node = nodes_[i];
      if (node.weight == 0) continue;
      places[i] = kept;
      nodes_[kept] = {.corner = node.corner,
                      .parent = node.parent == kNone ? kNone : places[node.parent],
                      .weight = node.weight};
      link(kept++);
    }
    nodes_.resize(kept);
  }

  const CornerGraph& graph_;
  const AllFirstCorners& first_;
  const HubLabelling& labelling_;
  const IndexBuilding& building_;
  Random random_{1};
  std::vector<Cell> cells_;                 // roots to choose from
  std::vector<std::uint32_t> cell_counts_;  // by corner: cells that may turn first there, and 1
  std::vector<Node> nodes_;                 // tree after tree, parents before their children
  std::size_t alive_ = 0;
  std::vector<std::uint32_t> first_nodes_;  // by corner
  std::vector<std::uint64_t> totals_;       // by corner

  // State of the tree that is being grown.
  std::vector<CornerCost> from_root_;  // by hub
  std::vector<std::uint32_t> hubs_;    // of the corners where paths from the root turn first
  CornerFrontier frontier_;
  std::vector<std::uint32_t> stack_;
};

LabelOrder::LabelOrder(const CornerGraph& graph, const AllFirstCorners& first,
                       const HubLabelling& labelling, const IndexBuilding& building)
    : labelling_(labelling),
      building_(building),
      trees_(std::make_unique<SampledTrees>(graph, first, labelling, building)),
      wanted_nodes_(kNodesPerCorner * graph.size()),
      nodes_of_late_(static_cast<double>(graph.size())),
      queued_(graph.size()) {}

LabelOrder::~LabelOrder() = default;

std::uint32_t LabelOrder::next() {
  grow_trees();
  while (!queue_.empty()) {
    const Candidate best = min_heap::pop(queue_);
    if (best.total != queued_[best.corner]) continue;  // it was queued again with a larger total
    queued_[best.corner] = 0;
    const std::uint64_t total = trees_->total(best.corner);
    if (total == best.total) {
      trees_->cut(best.corner);
      return best.corner;
    }
    if (total > 0) push(best.corner, total);
  }
  while (labelling_.is_hub(rest_)) ++rest_;
  return rest_;
}

void LabelOrder::grow_trees() {
  while (!building_.cancelled() && !all_told_ &&
         (grown_ < kFirstTrees || trees_->size() < wanted_nodes_)) {
    const std::size_t nodes = trees_->grow([&](std::uint32_t corner) {
      const std::uint64_t total = trees_->total(corner);
      // Leaves room to grow, so that not every tree queues the corner again.
      if (total > queued_[corner]) push(corner, total + total / 4);
    });
    ++grown_;
    nodes_of_late_ =
        kMemoryOfMean * nodes_of_late_ + (1 - kMemoryOfMean) * static_cast<double>(nodes);
    all_told_ = nodes_of_late_ < kFewNodes;
  }
}

void LabelOrder::push(std::uint32_t corner, std::uint64_t total) {
  queued_[corner] = total;
  min_heap::push(queue_, {total, corner});
}

}  // namespace wend
