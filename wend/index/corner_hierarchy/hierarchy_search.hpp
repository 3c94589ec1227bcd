#pragma once

// HierarchySearch: shortest paths in a ContractionHierarchy, from many starts to many goals.
//
// Two searches climb, one along leaving arcs from the starts and one along entering arcs from the goals,
// and meet at the top of the path. In the core only the forward one goes on. Both are A*, each guided by
// an estimate of the rest, which must be consistent, and stop where their keys reach the cost of the
// best path so far. (Stall-on-demand, the usual check whether a node is reached more cheaply from above,
// costs more than it saves here: the estimates keep the climbs narrow.)
//
// The search asks for starts and goals only when it needs them; most are never needed.
//
// Each thread needs its own search; the hierarchy may be shared and must outlive it. Memory: 16 bytes
// per node.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wend/index/corner_hierarchy/contraction_hierarchy.hpp"
#include "wend/search/jump_queue.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

/// Where a search begins or ends.
struct HierarchyEnd {
  HierarchyCost cost = 0;  // from the start to it, or from it to the goal
  HierarchyCost key = 0;   // a lower bound on paths that begin or end there; at least `cost`
};

class HierarchySearch {
 public:
  static constexpr HierarchyCost kNoCost = std::numeric_limits<HierarchyCost>::max();

  /// The queue ignores the last bits of keys.
  explicit HierarchySearch(const ContractionHierarchy& hierarchy, unsigned unordered_bits)
      : hierarchy_(hierarchy), unordered_bits_(unordered_bits), labels_(hierarchy.size()) {}

  /// The cost of the cheapest path, its ends' costs included, if it is less than `bound`; else `bound`.
  /// The query provides:
  ///   for_each_start(i, visit)  visit(node) of each node that starts[i] stands for; for_each_goal too
  ///   to_goal(node)             at most what leads from a node to a goal and on; consistent
  ///   to_start(node)            at most what leads from the starts to it; consistent
  /// The key of an end is at most its cost plus the estimate by one of these.
  template <class HierarchyQuery>
  HierarchyCost find(std::span<const HierarchyEnd> starts, std::span<const HierarchyEnd> goals,
                     HierarchyCost bound, const HierarchyQuery& query);

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

  /// One direction, as a query sees it.
  template <Side kSide, class HierarchyQuery>
  struct View {
    const HierarchyQuery& query;
    std::span<const HierarchyEnd> ends;

    HierarchyCost estimate(std::uint32_t node) const {
      return kSide == forward ? query.to_goal(node) : query.to_start(node);
    }
    template <class Visit>
    void for_each_node(std::uint32_t end, Visit&& visit) const {
      if constexpr (kSide == forward) {
        query.for_each_start(end, visit);
      } else {
        query.for_each_goal(end, visit);
      }
    }
  };

  void forget();
  template <Side kSide>
  void begin(std::span<const HierarchyEnd> ends);
  template <Side kSide, class HierarchyQuery>
  void expand_least(const View<kSide, HierarchyQuery>& view);
  template <Side kSide, class HierarchyQuery>
  void expand(std::uint32_t node, const View<kSide, HierarchyQuery>& view);
  template <Side kSide>
  bool improve(std::uint32_t node, std::uint64_t cost, std::uint64_t key, std::uint32_t from);
  template <Side kSide>
  std::span<const HierarchyArc> arcs_of(std::uint32_t node) const {
    return kSide == forward ? hierarchy_.leaving_of(node) : hierarchy_.entering_of(node);
  }
  void append_arc(std::span<const HierarchyArc> arcs, std::uint32_t to,
                  std::vector<std::uint32_t>& nodes);

  ContractionHierarchy hierarchy_;
  unsigned unordered_bits_;
  std::vector<Label> labels_;
  std::vector<std::uint32_t> touched_;
  JumpQueue<HierarchyCost> queues_[2];  // numbers of nodes, and after these numbers of ends
  HierarchyCost keys_[2] = {};          // popped last
  std::vector<std::uint32_t> climb_;
  std::vector<std::uint32_t> pieces_;  // arcs to unpack
  HierarchyCost best_ = kNoCost;
  std::uint32_t meeting_ = kNoNode;
  SearchMetrics metrics_;
};

template <class HierarchyQuery>
HierarchyCost HierarchySearch::find(std::span<const HierarchyEnd> starts,
                                    std::span<const HierarchyEnd> goals, HierarchyCost bound,
                                    const HierarchyQuery& query) {
  const View<forward, HierarchyQuery> from_start{query, starts};
  const View<backward, HierarchyQuery> from_goal{query, goals};
  forget();
  best_ = bound;
  begin<forward>(starts);
  begin<backward>(goals);
  const auto& forth = queues_[forward];
  const auto& back = queues_[backward];
  while (!forth.empty() || !back.empty()) {
    metrics_.max_frontier =
        std::max<std::uint64_t>(metrics_.max_frontier, forth.size() + back.size());
    if (forth.empty() || (!back.empty() && keys_[backward] <= keys_[forward])) {
      expand_least(from_goal);
    } else {
      expand_least(from_start);
    }
  }
  return best_;
}

template <HierarchySearch::Side kSide>
void HierarchySearch::begin(std::span<const HierarchyEnd> ends) {
  HierarchyCost least = kNoCost;
  for (const HierarchyEnd& end : ends) least = std::min(least, end.key);
  auto& queue = queues_[kSide];
  queue.begin(least, unordered_bits_);
  keys_[kSide] = least;
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    if (ends[i].key < best_) queue.push(ends[i].key, hierarchy_.size() + i);
  }
}

template <HierarchySearch::Side kSide, class HierarchyQuery>
void HierarchySearch::expand_least(const View<kSide, HierarchyQuery>& view) {
  auto& queue = queues_[kSide];
  const auto [key, id] = queue.pop();
  keys_[kSide] = key;
  if (key >= best_) {
    if (queue.bucket_is_behind(best_)) queue.begin(key, unordered_bits_);  // no other is better
    return;
  }
  if (id < hierarchy_.size()) {
    const HierarchyCost cost = labels_[id].costs[kSide];
    if (key == cost + view.estimate(id)) expand(id, view);  // else reached more cheaply since
    return;
  }
  const std::uint32_t end = id - hierarchy_.size();
  view.for_each_node(end, [&](std::uint32_t node) {
    if (improve<kSide>(node, view.ends[end].cost, key, kNoNode)) expand(node, view);
  });
}

template <HierarchySearch::Side kSide, class HierarchyQuery>
void HierarchySearch::expand(std::uint32_t node, const View<kSide, HierarchyQuery>& view) {
  ++metrics_.expanded;
  const HierarchyCost cost = labels_[node].costs[kSide];
  for (const HierarchyArc& arc : arcs_of<kSide>(node)) {
    const std::uint64_t longer = std::uint64_t{cost} + arc.cost;
    if (longer >= labels_[arc.node].costs[kSide]) continue;
    const std::uint64_t key = longer + view.estimate(arc.node);
    if (improve<kSide>(arc.node, longer, key, node)) {
      queues_[kSide].push(static_cast<HierarchyCost>(key), arc.node);
    }
  }
}

/// Records a path to the node if it is cheaper and may be part of a path better than the best. Returns
/// whether it did.
template <HierarchySearch::Side kSide>
bool HierarchySearch::improve(std::uint32_t node, std::uint64_t cost, std::uint64_t key,
                              std::uint32_t from) {
  Label& label = labels_[node];
  if (cost >= label.costs[kSide] || key >= best_) return false;
  if (label.untouched()) touched_.push_back(node);
  ++metrics_.generated;
  label.costs[kSide] = static_cast<HierarchyCost>(cost);
  label.from[kSide] = from;
  const HierarchyCost other = label.costs[kSide == forward ? backward : forward];
  if (other != kNoCost && other + cost < best_) {
    best_ = static_cast<HierarchyCost>(other + cost);
    meeting_ = node;
  }
  return true;
}

inline void HierarchySearch::forget() {
  for (const std::uint32_t node : touched_) labels_[node] = {};
  touched_.clear();
  meeting_ = kNoNode;
  metrics_ = {};
}

inline void HierarchySearch::append_nodes(std::vector<std::uint32_t>& nodes) {
  climb_.clear();
  for (std::uint32_t node = meeting_; node != kNoNode; node = labels_[node].from[forward]) {
    climb_.push_back(node);
  }
  nodes.push_back(climb_.back());
  for (std::size_t i = climb_.size() - 1; i > 0; --i) {
    append_arc(hierarchy_.leaving_of(climb_[i]), climb_[i - 1], nodes);
  }
  for (std::uint32_t node = meeting_; labels_[node].from[backward] != kNoNode;) {
    const std::uint32_t next = labels_[node].from[backward];
    append_arc(hierarchy_.entering_of(next), node, nodes);
    node = next;
  }
}

/// Appends the nodes of the arc to or from `to`, without its tail.
inline void HierarchySearch::append_arc(std::span<const HierarchyArc> arcs, std::uint32_t to,
                                        std::vector<std::uint32_t>& nodes) {
  const HierarchyArc* arc = arcs.data();
  while (arc->node != to) ++arc;
  pieces_.push_back(static_cast<std::uint32_t>(arc - hierarchy_.arcs.data()));
  while (!pieces_.empty()) {
    const HierarchyVia& via = hierarchy_.vias[pieces_.back()];
    pieces_.pop_back();
    if (via.shortcut()) {
      pieces_.push_back(via.leaving);
      pieces_.push_back(via.entering);
    } else {
      nodes.push_back(via.head());
    }
  }
}

}  // namespace wend
