#pragma once

// HierarchySearch: shortest paths in a ContractionHierarchy, from many starts to many goals.
//
// Two searches climb, one along leaving arcs from the starts and one along entering arcs from the
// goals, and meet at the top of the path. In the core only the forward one goes on. Both are A*,
// each guided by an estimate of the rest, which must be consistent, and stop where their keys reach
// the cost of the best path so far. (To look whether a node is reached more
// cheaply from above, as is often done, takes longer here than it saves: the estimates keep the
// climbs narrow.)
//
// One search a thread; the hierarchy may be shared, and must outlive it. Memory: 16 bytes a node.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wend/index/contraction_hierarchy.hpp"
#include "wend/search/min_heap.hpp"
#include "wend/search/search_metrics.hpp"

namespace wend {

/// Where a search begins or ends, and what it costs to come there, or to go on from there.
struct HierarchyEnd {
  std::uint32_t node = 0;
  HierarchyCost cost = 0;
};

class HierarchySearch {
 public:
  static constexpr HierarchyCost kNoCost = std::numeric_limits<HierarchyCost>::max();

  explicit HierarchySearch(const ContractionHierarchy& hierarchy)
      : hierarchy_(hierarchy), labels_(hierarchy.size()) {}

  /// The cost of the cheapest path, its ends' costs included, if it is less than `bound`; else
  /// `bound`. estimates.to_goal(node) is at most what leads from a node to a goal and on, to_start(node)
  /// what leads from the starts to it.
  template <class Estimates>
  HierarchyCost find(std::span<const HierarchyEnd> starts, std::span<const HierarchyEnd> goals,
                     HierarchyCost bound, const Estimates& estimates);

  /// Appends the nodes of the graph on the path found last, start and goal included. There must be
  /// one: find() returned less than its bound.
  void append_nodes(std::vector<std::uint32_t>& nodes);

  /// Of the last find().
  const SearchMetrics& metrics() const { return metrics_; }

 private:
  enum Side : std::size_t { forward, backward };

  static constexpr std::uint32_t kNoNode = static_cast<std::uint32_t>(-1);

  struct Label {
    HierarchyCost costs[2] = {kNoCost, kNoCost};
    std::uint32_t from[2] = {kNoNode, kNoNode};  // the node before; kNoNode: an end

    bool untouched() const { return costs[forward] == kNoCost && costs[backward] == kNoCost; }
  };

  static std::uint64_t entry(std::uint64_t key, std::uint32_t node) { return key << 32U | node; }

  void forget();
  template <Side kSide, class Estimate>
  void begin(std::span<const HierarchyEnd> ends, const Estimate& estimate);
  template <Side kSide, class Estimate>
  void expand_least(const Estimate& estimate);
  template <Side kSide, class Estimate>
  void reach(std::uint32_t node, std::uint64_t cost, std::uint32_t from, const Estimate& estimate);
  template <Side kSide>
  std::span<const HierarchyArc> arcs_of(std::uint32_t node) const {
    return kSide == forward ? hierarchy_.leaving_of(node) : hierarchy_.entering_of(node);
  }
  void append_arc(std::span<const HierarchyArc> arcs, std::uint32_t to,
                  std::vector<std::uint32_t>& nodes);

  ContractionHierarchy hierarchy_;
  std::vector<Label> labels_;
  std::vector<std::uint32_t> touched_;
  std::vector<std::uint64_t> queues_[2];  // key, then node
  std::vector<std::uint32_t> climb_;
  std::vector<std::uint32_t> pieces_;  // arcs to unpack
  HierarchyCost best_ = kNoCost;
  std::uint32_t meeting_ = kNoNode;
  SearchMetrics metrics_;
};

template <class Estimates>
HierarchyCost HierarchySearch::find(std::span<const HierarchyEnd> starts,
                                    std::span<const HierarchyEnd> goals, HierarchyCost bound,
                                    const Estimates& estimates) {
  const auto to_goal = [&](std::uint32_t node) { return estimates.to_goal(node); };
  const auto to_start = [&](std::uint32_t node) { return estimates.to_start(node); };
  forget();
  best_ = bound;
  begin<backward>(goals, to_start);
  begin<forward>(starts, to_goal);
  const auto& forth = queues_[forward];
  const auto& back = queues_[backward];
  while (!forth.empty() || !back.empty()) {
    metrics_.max_frontier =
        std::max<std::uint64_t>(metrics_.max_frontier, forth.size() + back.size());
    if (forth.empty() || (!back.empty() && back.front() < forth.front())) {
      expand_least<backward>(to_start);
    } else {
      expand_least<forward>(to_goal);
    }
  }
  return best_;
}

template <HierarchySearch::Side kSide, class Estimate>
void HierarchySearch::begin(std::span<const HierarchyEnd> ends, const Estimate& estimate) {
  auto& queue = queues_[kSide];
  for (const HierarchyEnd& end : ends) {
    // Not pushed: it is made a heap of at the end.
    const std::uint64_t key = std::uint64_t{end.cost} + estimate(end.node);
    Label& label = labels_[end.node];
    if (key >= best_ || end.cost >= label.costs[kSide]) continue;
    if (label.untouched()) touched_.push_back(end.node);
    if (label.costs[kSide] == kNoCost) ++metrics_.generated;
    label.costs[kSide] = end.cost;
    label.from[kSide] = kNoNode;
    queue.push_back(entry(key, end.node));
    const HierarchyCost other = label.costs[kSide == forward ? backward : forward];
    if (other != kNoCost && std::uint64_t{other} + end.cost < best_) {
      best_ = other + end.cost;
      meeting_ = end.node;
    }
  }
  min_heap::make(queue);
}

template <HierarchySearch::Side kSide, class Estimate>
void HierarchySearch::expand_least(const Estimate& estimate) {
  auto& queue = queues_[kSide];
  const std::uint64_t least = min_heap::pop(queue);
  const auto node = static_cast<std::uint32_t>(least);
  const HierarchyCost cost = labels_[node].costs[kSide];
  if (least >> 32U >= best_) {
    queue.clear();
    return;
  }
  if (least >> 32U != std::uint64_t{cost} + estimate(node)) return;  // reached more cheaply since
  ++metrics_.expanded;
  for (const HierarchyArc& arc : arcs_of<kSide>(node)) {
    reach<kSide>(arc.node, std::uint64_t{cost} + arc.cost, node, estimate);
  }
}

template <HierarchySearch::Side kSide, class Estimate>
void HierarchySearch::reach(std::uint32_t node, std::uint64_t cost, std::uint32_t from,
                            const Estimate& estimate) {
  Label& label = labels_[node];
  if (cost >= label.costs[kSide]) return;
  const std::uint64_t key = cost + estimate(node);
  if (key >= best_) return;
  if (label.untouched()) touched_.push_back(node);
  if (label.costs[kSide] == kNoCost) ++metrics_.generated;
  label.costs[kSide] = static_cast<HierarchyCost>(cost);
  label.from[kSide] = from;
  const HierarchyCost other = label.costs[kSide == forward ? backward : forward];
  if (other != kNoCost && other + cost < best_) {
    best_ = static_cast<HierarchyCost>(other + cost);
    meeting_ = node;
  }
  min_heap::push(queues_[kSide], entry(key, node));
}

}  // namespace wend
