#include "wend/index/corner_hierarchy/graph_contraction.hpp"

#include <algorithm>
#include <utility>

#include "wend/index/corner_hierarchy/hierarchy_assembly.hpp"
#include "wend/index/corner_hierarchy/shrinking_graph.hpp"
#include "wend/index/corner_hierarchy/witness_search.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

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
        is_out_(nodes) {}

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
      if (taken_out_.size() % kNodesBetweenTelling == 0) building.tell(share_done());
    }
    return !building.cancelled();
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
      if (witnesses_.work() >= most_work_) return;  // nothing will be taken out
      queue_.push_back({priority_of(node), node});
    }
    min_heap::make(queue_);
  }

  /// How many arcs there will be for each that goes, and how many nodes were taken out below this
  /// one in a chain: so that they are taken out evenly all over the graph.
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
  std::uint64_t most_work_;
  ShrinkingGraph graph_;
  WitnessSearch witnesses_;
  std::vector<Candidate> queue_;
  std::vector<std::uint32_t> depths_;  // nodes taken out in a chain below a node
  std::vector<bool> is_out_;
  std::vector<std::uint32_t> taken_out_;  // in this order
  std::vector<GraphArc> shortcuts_;
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
