#include "wend/index/corner_hierarchy/witness_search.hpp"

#include <algorithm>
#include <limits>

#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kMostCost = std::numeric_limits<HierarchyCost>::max();
constexpr std::uint64_t kWorkPerNode = 4;  // what settling a node takes besides its arcs, in arcs

std::uint64_t entry(std::uint64_t cost, std::uint32_t node) { return cost << 32U | node; }

}  // namespace

void WitnessSearch::find_shortcuts(const ShrinkingGraph& graph, std::uint32_t node,
                                   std::uint32_t most_settled, std::vector<GraphArc>& shortcuts) {
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
      // A way that costs more than 32 bits hold is no shortest one.
      if (label.target != search_ || through >= kMostCost) continue;
      if (label.search == search_ && label.cost <= through) continue;
      shortcuts.push_back({tail.node, head.node, static_cast<HierarchyCost>(through)});
    }
  }
}

std::uint32_t WitnessSearch::mark_targets(const ShrinkingGraph& graph, std::uint32_t node,
                                          std::uint32_t tail) {
  std::uint32_t targets = 0;
  for (const auto& head : graph.leaving(node)) {
    if (head.node == tail) continue;
    labels_[head.node].target = search_;
    ++targets;
  }
  return targets;
}

void WitnessSearch::search(const ShrinkingGraph& graph, std::uint32_t without, std::uint32_t from,
                           std::uint64_t farthest, std::uint32_t targets,
                           std::uint32_t most_settled) {
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

}  // namespace wend
