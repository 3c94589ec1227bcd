#include "wend/index/hub_labels/label_order.hpp"

#include <algorithm>

#include "wend/base/random.hpp"
#include "wend/index/sampled_forest.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::size_t kFirstTrees = 16;
constexpr std::size_t kNodesPerCorner = 16;
constexpr double kFewNodes = 20;        // per tree
constexpr double kMemoryOfMean = 0.99;  // of the running mean

}  // namespace

// SampledTrees: a SampledForest from random cells, without what the hubs chosen so far cover. The weight of a node
// counts, for each corner in its subtree, the cells that may turn first at it: so the total of a corner is roughly
// the number of paths between cells that it would cover as the next hub. (To sample cells, and to weigh by cells, makes
// smaller labels than to sample from the nodes of the graph.)

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
        forest_(graph.size()),
        from_root_(graph.size(), kUnreachedCost),
        frontier_(graph.size()) {
    for (const Cell cell : every_cell(graph.corners().passable())) {
      const auto list = first.of(cell);
      if (!list.empty()) cells_.push_back(cell);
      for (const std::uint32_t corner : list) ++cell_counts_[corner];
    }
  }

  /// The number of nodes in all trees.
  std::size_t size() const { return forest_.size(); }
  std::uint64_t total(std::uint32_t corner) const { return forest_.total(corner); }

  /// Grows a tree from a random cell; calls grew(corner) for the corners whose total it raised. Returns
  /// their number.
  template <class Grew>
  std::size_t grow(Grew&& grew) {
    forest_.begin_tree();
    if (!cells_.empty()) grow_nodes();
    return forest_.end_tree(grew);
  }

  /// Cuts off the subtrees of all nodes of a corner.
  void cut(std::uint32_t corner) { forest_.cut(corner); }

 private:
  void grow_nodes() {
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
  }

  void spread() {
    while (!frontier_.empty() && !building_.cancelled()) {
      const CornerFrontier::Entry next = frontier_.pop();
      if (frontier_.is_outdated(next)) continue;
      if (covers(labelling_.label(next.corner), from_root_, next.cost)) continue;
      const std::uint32_t place = forest_.add(next.corner, next.parent, cell_counts_[next.corner]);
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
    reach({cost, corner, SampledForest::kNone});
  }

  void reach(const CornerFrontier::Entry& entry) {
    if (!labelling_.is_hub(entry.corner)) frontier_.reach(entry);
  }

  const CornerGraph& graph_;
  const AllFirstCorners& first_;
  const HubLabelling& labelling_;
  const IndexBuilding& building_;
  Random random_{1};
  std::vector<Cell> cells_;                 // roots to choose from
  std::vector<std::uint32_t> cell_counts_;  // by corner: cells that may turn first there, and 1
  SampledForest forest_;

  // State of the tree that is being grown.
  std::vector<CornerCost> from_root_;  // by hub
  std::vector<std::uint32_t> hubs_;    // of the corners where paths from the root turn first
  CornerFrontier frontier_;
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
