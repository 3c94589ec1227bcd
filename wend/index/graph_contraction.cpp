#include "wend/index/graph_contraction.hpp"

#include <algorithm>
#include <limits>

#include "wend/index/shrinking_graph.hpp"
#include "wend/index/witness_search.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::uint32_t kInGraph = static_cast<std::uint32_t>(-1);

/// Who is taken out next: the node with the least priority, of these the one numbered lowest.
struct Candidate {
  std::int64_t priority;
  std::uint32_t node;

  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

class Contraction {
 public:
  Contraction(std::uint32_t nodes, std::span<const GraphArc> arcs, const ContractionEffort& effort)
      : effort_(effort),
        most_work_(effort.work_per_node * nodes),
        graph_(nodes, arcs),
        witnesses_(nodes),
        depths_(nodes),
        heights_(nodes, kInGraph) {}

  bool run(const IndexBuilding& building) {
    rank_all();
    while (!queue_.empty() && witnesses_.work() < most_work_) {
      if (building.cancelled()) return false;
      const Candidate candidate = min_heap::pop(queue_);
      const std::int64_t priority = priority_of(candidate.node);
      if (!queue_.empty() && priority > queue_.front().priority) {
        min_heap::push(queue_, {priority, candidate.node});
        continue;
      }
      take_out(candidate.node);
      if (taken_out_ % kNodesBetweenTelling == 0) building.tell(share_done());
    }
    return !building.cancelled();
  }

  ContractedGraph finish() {
    ContractedGraph result;
    result.core_begin = taken_out_;
    for (std::uint32_t& height : heights_) {
      if (height == kInGraph) height = taken_out_++;
    }
    nodes_.resize(heights_.size());
    for (std::uint32_t node = 0; node < heights_.size(); ++node) nodes_[heights_[node]] = node;
    for (const std::uint32_t node : nodes_) append_arcs(node, result);
    result.begins.push_back(ends(result));
    append_vias(result);
    result.heights = std::move(heights_);
    return result;
  }

 private:
  static constexpr std::uint32_t kNodesBetweenTelling = 256;

  double share_done() const {
    return static_cast<double>(taken_out_) / static_cast<double>(heights_.size());
  }

  void rank_all() {
    for (std::uint32_t node = 0; node < heights_.size(); ++node) {
      if (witnesses_.work() >= most_work_) return;  // nothing will be taken out
      queue_.push_back({priority_of(node), node});
    }
    min_heap::make(queue_);
  }

  /// Twice what the graph grows by without the node, and how many nodes were taken out below it in
  /// a chain: so that they are taken out evenly all over the graph.
  std::int64_t priority_of(std::uint32_t node) {
    witnesses_.find_shortcuts(graph_, node, effort_.settled_to_rank, shortcuts_);
    const auto more = static_cast<std::int64_t>(shortcuts_.size());
    const auto fewer =
        static_cast<std::int64_t>(graph_.leaving(node).size() + graph_.entering(node).size());
    return 2 * (more - fewer) + depths_[node];
  }

  void take_out(std::uint32_t node) {
    witnesses_.find_shortcuts(graph_, node, effort_.settled_to_contract, shortcuts_);
    for (const GraphArc& shortcut : shortcuts_) graph_.add(shortcut, node);
    for (const auto& arc : graph_.leaving(node)) deepen(arc.node, node);
    for (const auto& arc : graph_.entering(node)) deepen(arc.node, node);
    graph_.detach(node);
    heights_[node] = taken_out_++;
  }

  void deepen(std::uint32_t neighbour, std::uint32_t node) {
    depths_[neighbour] = std::max(depths_[neighbour], depths_[node] + 1);
  }

  static HierarchyNode ends(const ContractedGraph& result) {
    return {static_cast<std::uint32_t>(result.leaving.size()),
            static_cast<std::uint32_t>(result.entering.size())};
  }

  void append_arcs(std::uint32_t node, ContractedGraph& result) {
    result.begins.push_back(ends(result));
    for (const auto& arc : graph_.leaving(node)) {
      result.leaving.push_back({heights_[arc.node], arc.cost});
    }
    if (heights_[node] >= result.core_begin) return;
    for (const auto& arc : graph_.entering(node)) {
      result.entering.push_back({heights_[arc.node], arc.cost});
    }
  }

  void append_vias(ContractedGraph& result) const {
    for (const std::uint32_t node : nodes_) {
      for (const auto& arc : graph_.leaving(node)) {
        result.leaving_vias.push_back(via_of(result, node, arc.node, arc.middle));
      }
      if (heights_[node] >= result.core_begin) continue;
      for (const auto& arc : graph_.entering(node)) {
        result.entering_vias.push_back(via_of(result, arc.node, node, arc.middle));
      }
    }
  }

  HierarchyVia via_of(const ContractedGraph& result, std::uint32_t tail, std::uint32_t head,
                      std::uint32_t middle) const {
    if (middle == ShrinkingGraph::kNoMiddle) return {HierarchyVia::kNoArc, heights_[head]};
    const HierarchyNode& begin = result.begins[heights_[middle]];
    return {begin.entering + place_in(graph_.entering(middle), tail),
            begin.leaving + place_in(graph_.leaving(middle), head)};
  }

  static std::uint32_t place_in(std::span<const ShrinkingGraph::Arc> arcs, std::uint32_t node) {
    const auto found = std::find_if(arcs.begin(), arcs.end(),
                                    [node](const auto& arc) { return arc.node == node; });
    return static_cast<std::uint32_t>(found - arcs.begin());
  }

  ContractionEffort effort_;
  std::uint64_t most_work_;
  ShrinkingGraph graph_;
  WitnessSearch witnesses_;
  std::vector<Candidate> queue_;
  std::vector<std::uint32_t> depths_;   // nodes taken out in a chain below a node
  std::vector<std::uint32_t> heights_;  // kInGraph: not taken out
  std::vector<std::uint32_t> nodes_;    // by height
  std::vector<GraphArc> shortcuts_;
  std::uint32_t taken_out_ = 0;
};

}  // namespace

Expected<ContractedGraph, IndexError> contract(std::uint32_t nodes, std::span<const GraphArc> arcs,
                                               const ContractionEffort& effort,
                                               const IndexBuilding& building) {
  Contraction contraction(nodes, arcs, effort);
  if (!contraction.run(building)) {
    return Unexpected<IndexError>({Status::cancelled, "the index was not finished"});
  }
  return contraction.finish();
}

}  // namespace wend
