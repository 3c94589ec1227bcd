#include "wend/index/corner_hierarchy/hierarchy_assembly.hpp"

#include <algorithm>
#include <utility>

namespace wend {
namespace {

/// All searches reach the topmost nodes, so these stay together.
constexpr std::size_t kTopShare = 16;

std::vector<std::uint32_t> heights_of(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> heights(order.size());
  for (std::uint32_t height = 0; height < order.size(); ++height) heights[order[height]] = height;
  return heights;
}

/// For each node, the nodes directly below it: those with an arc whose upper end is this node.
class NodesBelow {
 public:
  NodesBelow(const ShrinkingGraph& graph, std::span<const std::uint32_t> taken_out,
             std::size_t nodes)
      : begins_(nodes + 1) {
    for_each_arc(graph, taken_out,
                 [&](std::uint32_t /*node*/, std::uint32_t upper) { ++begins_[upper + 1]; });
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    below_.resize(begins_.back());
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for_each_arc(graph, taken_out,
                 [&](std::uint32_t node, std::uint32_t upper) { below_[next[upper]++] = node; });
  }

  std::span<const std::uint32_t> of(std::uint32_t node) const {
    return std::span(below_).subspan(begins_[node], begins_[node + 1] - begins_[node]);
  }

 private:
  template <class Visit>
  static void for_each_arc(const ShrinkingGraph& graph, std::span<const std::uint32_t> nodes,
                           Visit&& visit) {
    for (const std::uint32_t node : nodes) {
      for (const auto& arc : graph.leaving(node)) visit(node, arc.node);
      for (const auto& arc : graph.entering(node)) visit(node, arc.node);
    }
  }

  std::vector<std::size_t> begins_;
  std::vector<std::uint32_t> below_;
};

/// Reorders the nodes below the topmost ones in post-order: each node comes after the nodes directly
/// below it that have no place yet, and these after the nodes below them. Arcs still climb.
class Gathering {
 public:
  Gathering(const ShrinkingGraph& graph, std::vector<std::uint32_t>& order,
            std::uint32_t core_begin)
      : below_(graph, std::span(order).first(core_begin), order.size()),
        placed_(order.size()),
        order_(order) {
    const std::size_t begin_of_top =
        std::min<std::size_t>(core_begin, order.size() - order.size() / kTopShare);
    gathered_.reserve(begin_of_top);
    for (std::size_t i = begin_of_top; i < order.size(); ++i) placed_[order[i]] = true;
    for (std::size_t i = order.size(); i-- > begin_of_top;) place_all_below(order[i]);
    for (std::size_t i = begin_of_top; i-- > 0;) place(order[i]);
    std::copy(gathered_.begin(), gathered_.end(), order_.begin());
  }

 private:
  struct Visited {
    std::uint32_t node;
    std::size_t next = 0;  // index among the nodes below it
  };

  void place(std::uint32_t node) {
    if (placed_[node]) return;
    placed_[node] = true;
    place_all_below(node);
    gathered_.push_back(node);
  }

  void place_all_below(std::uint32_t top) {
    std::vector<Visited>& way = way_;
    way.push_back({top});
    for (;;) {
      Visited& visited = way.back();
      const auto below = below_.of(visited.node);
      if (visited.next < below.size()) {
        const std::uint32_t node = below[visited.next++];
        if (placed_[node]) continue;
        placed_[node] = true;
        way.push_back({node});
        continue;
      }
      const std::uint32_t done = visited.node;
      way.pop_back();
      if (way.empty()) return;
      gathered_.push_back(done);
    }
  }

  NodesBelow below_;
  std::vector<bool> placed_;
  std::vector<std::uint32_t>& order_;
  std::vector<std::uint32_t> gathered_;
  std::vector<Visited> way_;  // from a topmost node down
};

class Assembly {
 public:
  Assembly(const ShrinkingGraph& graph, std::span<const std::uint32_t> order,
           std::uint32_t core_begin)
      : graph_(graph) {
    result_.core_begin = core_begin;
    result_.heights = heights_of(order);
    for (const std::uint32_t node : order) append_arcs(node);
    result_.nodes.push_back({arc_count(), arc_count()});
    for (const std::uint32_t node : order) append_vias(node);
  }

  ContractedGraph result() && { return std::move(result_); }

 private:
  std::uint32_t height(std::uint32_t node) const { return result_.heights[node]; }
  bool in_core(std::uint32_t node) const { return height(node) >= result_.core_begin; }
  std::uint32_t arc_count() const { return static_cast<std::uint32_t>(result_.arcs.size()); }

  /// Arcs within the core are kept once, by the node that they leave.
  std::span<const ShrinkingGraph::Arc> entering(std::uint32_t node) const {
    return in_core(node) ? std::span<const ShrinkingGraph::Arc>() : graph_.entering(node);
  }

  void append_arcs(std::uint32_t node) {
    HierarchyNode begins{arc_count(), 0};
    for (const auto& arc : graph_.leaving(node)) {
      result_.arcs.push_back({height(arc.node), arc.cost});
    }
    begins.entering = arc_count();
    for (const auto& arc : entering(node)) result_.arcs.push_back({height(arc.node), arc.cost});
    result_.nodes.push_back(begins);
  }

  void append_vias(std::uint32_t node) {
    for (const auto& arc : graph_.leaving(node)) {
      result_.vias.push_back(via_of(node, arc.node, arc.middle));
    }
    for (const auto& arc : entering(node)) {
      result_.vias.push_back(via_of(arc.node, node, arc.middle));
    }
  }

  HierarchyVia via_of(std::uint32_t tail, std::uint32_t head, std::uint32_t middle) const {
    if (middle == ShrinkingGraph::kNoMiddle) return {HierarchyVia::kNoArc, height(head)};
    const HierarchyNode& begins = result_.nodes[height(middle)];
    return {begins.entering + place_in(graph_.entering(middle), tail),
            begins.leaving + place_in(graph_.leaving(middle), head)};
  }

  static std::uint32_t place_in(std::span<const ShrinkingGraph::Arc> arcs, std::uint32_t node) {
    const auto found = std::find_if(arcs.begin(), arcs.end(),
                                    [node](const auto& arc) { return arc.node == node; });
    return static_cast<std::uint32_t>(found - arcs.begin());
  }

  const ShrinkingGraph& graph_;
  ContractedGraph result_;
};

}  // namespace

ContractedGraph assemble(const ShrinkingGraph& graph, std::vector<std::uint32_t> order,
                         std::uint32_t core_begin) {
  const Gathering gathering(graph, order, core_begin);
  return Assembly(graph, order, core_begin).result();
}

}  // namespace wend
