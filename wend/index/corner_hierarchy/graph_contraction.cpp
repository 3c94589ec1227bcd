#include "wend/index/corner_hierarchy/graph_contraction.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "wend/index/corner_hierarchy/hierarchy_assembly.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kMostCost = std::numeric_limits<HierarchyCost>::max();
constexpr std::uint64_t kWorkPerNode = 4;  // cost of settling a node besides its arcs, in arcs

std::uint64_t entry(std::uint64_t cost, std::uint32_t node) { return cost << 32U | node; }

/// Finds the shortcuts that a graph needs if a node is removed. Two neighbours need one if no path
/// around the node was found that is as short as the path through it.
class WitnessSearch {
 public:
  explicit WitnessSearch(std::uint32_t nodes) : labels_(nodes) {}

  /// Replaces `shortcuts` by those needed without the node. From each neighbour, a search settles at
  /// most `most_settled` nodes.
  void find_shortcuts(const ShrinkingGraph& graph, std::uint32_t node, std::uint32_t most_settled,
                      std::vector<GraphArc>& shortcuts) {
    shortcuts.clear();
    const auto heads = graph.leaving(node);
    work_ += kWorkPerNode;
    if (heads.empty()) return;
    const auto by_cost = [](const auto& a, const auto& b) { return a.cost < b.cost; };
    const std::uint64_t longest = std::max_element(heads.begin(), heads.end(), by_cost)->cost;
    for (const auto& tail : graph.entering(node)) {
      if (++search_ == 0) {
        std::fill(labels_.begin(), labels_.end(), Label{});
        search_ = 1;
      }
      const std::uint32_t targets = mark_targets(graph, node, tail.node);
      if (targets == 0) continue;
      search(graph, node, tail.node, std::min(tail.cost + longest, kMostCost - 1), targets,
             most_settled);
      for (const auto& head : heads) {
        const Label& label = labels_[head.node];
        const std::uint64_t through = std::uint64_t{tail.cost} + head.cost;
        // A path that costs more than 32 bits hold is not a shortest path.
        if (label.target != search_ || through >= kMostCost) continue;
        if (label.search == search_ && label.cost <= through) continue;
        shortcuts.push_back({tail.node, head.node, static_cast<HierarchyCost>(through)});
      }
    }
  }

  /// The number of arcs scanned so far, plus other work.
  std::uint64_t work() const { return work_; }

 private:
  struct Label {
    HierarchyCost cost = 0;
    std::uint32_t search = 0;  // the cost is of this search
    std::uint32_t target = 0;  // it is a target of this search
  };

  std::uint32_t mark_targets(const ShrinkingGraph& graph, std::uint32_t node, std::uint32_t tail) {
    std::uint32_t targets = 0;
    for (const auto& head : graph.leaving(node)) {
      if (head.node == tail) continue;
      labels_[head.node].target = search_;
      ++targets;
    }
    return targets;
  }

  void search(const ShrinkingGraph& graph, std::uint32_t without, std::uint32_t from,
              std::uint64_t farthest, std::uint32_t targets, std::uint32_t most_settled) {
    queue_.clear();
    labels_[from].cost = 0;
    labels_[from].search = search_;
    min_heap::push(queue_, entry(0, from));
    for (std::uint32_t settled = 0; settled < most_settled && !queue_.empty();) {
      const std::uint64_t least = min_heap::pop(queue_);
      const auto node = static_cast<std::uint32_t>(least);
      const std::uint64_t cost = least >> 32U;
      if (cost > labels_[node].cost) continue;
      if (labels_[node].target == search_ && --targets == 0) return;
      ++settled;
      const auto arcs = graph.leaving(node);
      work_ += kWorkPerNode + arcs.size();
      for (const auto& arc : arcs) {
        const std::uint64_t longer = cost + arc.cost;
        if (arc.node == without || longer > farthest) continue;
        Label& label = labels_[arc.node];
        if (label.search == search_ && label.cost <= longer) continue;
        label.cost = static_cast<HierarchyCost>(longer);
        label.search = search_;
        min_heap::push(queue_, entry(longer, arc.node));
      }
    }
  }

  std::vector<Label> labels_;
  std::vector<std::uint64_t> queue_;  // cost, then node
  std::uint32_t search_ = 0;
  std::uint64_t work_ = 0;
};

/// The next node to remove has the least priority and, among equals, the lowest number.
struct Candidate {
  std::int64_t priority;
  std::uint32_t node;

  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

class Contraction {
 public:
  Contraction(std::uint32_t nodes, std::span<const GraphArc> arcs, const ContractionEffort& effort,
              const IndexBuilding& building)
      : effort_(effort),
        building_(building),
        most_work_(effort.work_per_node * nodes),
        graph_(nodes, arcs, building),
        witnesses_(nodes),
        depths_(nodes),
        is_out_(nodes) {}

  /// False if the building was cancelled.
  bool run() {
    rank_all();
    while (!queue_.empty() && witnesses_.work() < most_work_) {
      if (building_.cancelled()) return false;
      const Candidate candidate = min_heap::pop(queue_);
      const std::int64_t priority = priority_of(candidate.node);
      if (!queue_.empty() && priority > queue_.front().priority) {
        min_heap::push(queue_, {priority, candidate.node});
        continue;
      }
      take_out(candidate.node);
      if (taken_out_.size() % kNodesBetweenTelling == 0) building_.tell(share_done());
    }
    return !building_.cancelled();
  }

  ContractedGraph finish() {
    const auto core_begin = static_cast<std::uint32_t>(taken_out_.size());
    for (std::uint32_t node = 0; node < is_out_.size(); ++node) {
      if (!is_out_[node]) taken_out_.push_back(node);
    }
    return assemble(graph_, std::move(taken_out_), core_begin);
  }

 private:
  static constexpr std::size_t kNodesBetweenTelling = 256;

  double share_done() const {
    return static_cast<double>(taken_out_.size()) / static_cast<double>(is_out_.size());
  }

  void rank_all() {
    for (std::uint32_t node = 0; node < is_out_.size(); ++node) {
      if (building_.cancelled()) return;
      if (witnesses_.work() >= most_work_) return;  // no node will be removed
      queue_.push_back({priority_of(node), node});
    }
    min_heap::make(queue_);
  }

  /// The number of new arcs per removed arc, plus the number of removed nodes in a chain below this
  /// node, so that nodes are removed evenly all over the graph.
  std::int64_t priority_of(std::uint32_t node) {
    constexpr std::int64_t kUnit = 1024;
    witnesses_.find_shortcuts(graph_, node, effort_.settled_to_rank, shortcuts_);
    const auto more = static_cast<std::int64_t>(shortcuts_.size());
    const auto fewer =
        static_cast<std::int64_t>(graph_.leaving(node).size() + graph_.entering(node).size());
    return kUnit * (1 + 2 * more) / (1 + fewer) + kUnit * depths_[node];
  }

  void take_out(std::uint32_t node) {
    witnesses_.find_shortcuts(graph_, node, effort_.settled_to_contract, shortcuts_);
    for (const GraphArc& shortcut : shortcuts_) graph_.add(shortcut, node);
    for (const auto& arc : graph_.leaving(node)) deepen(arc.node, node);
    for (const auto& arc : graph_.entering(node)) deepen(arc.node, node);
    graph_.detach(node);
    is_out_[node] = true;
    taken_out_.push_back(node);
  }

  void deepen(std::uint32_t neighbour, std::uint32_t node) {
    depths_[neighbour] = std::max(depths_[neighbour], depths_[node] + 1);
  }

  ContractionEffort effort_;
  const IndexBuilding& building_;
  std::uint64_t most_work_;
  ShrinkingGraph graph_;
  WitnessSearch witnesses_;
  std::vector<Candidate> queue_;
  std::vector<std::uint32_t> depths_;  // removed nodes in a chain below a node
  std::vector<bool> is_out_;
  std::vector<std::uint32_t> taken_out_;  // in this order
  std::vector<GraphArc> shortcuts_;
};

}  // namespace

Expected<ContractedGraph, Error> contract(std::uint32_t nodes, std::span<const GraphArc> arcs,
                                          const ContractionEffort& effort,
                                          const IndexBuilding& building) {
  Contraction contraction(nodes, arcs, effort, building);
  if (!contraction.run()) {
    return failure(Status::cancelled, "the index was not finished");
  }
  return contraction.finish();
}

}  // namespace wend
