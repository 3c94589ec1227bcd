#include "wend/index/hub_labels/sampled_trees.hpp"

#include <algorithm>

namespace wend {

SampledTrees::SampledTrees(const CornerGraph& graph, const AllFirstCorners& first,
                           const HubLabelling& labelling)
    : graph_(graph),
      first_(first),
      labelling_(labelling),
      cell_counts_(graph.size(), 1),
      first_nodes_(graph.size(), kNone),
      totals_(graph.size()),
      from_root_(graph.size(), kUnreachedCost),
      frontier_(graph.size()) {
  const BitGrid& passable = graph.corners().passable();
  for (int y = 0; y < passable.height(); ++y) {
    for (int x = 0; x < passable.width(); ++x) {
      const auto list = first.of({x, y});
      if (!list.empty()) cells_.push_back({x, y});
      for (const std::uint32_t corner : list) ++cell_counts_[corner];
    }
  }
}

std::size_t SampledTrees::grow_nodes() {
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

void SampledTrees::start_at(std::uint32_t corner, CornerCost cost) {
  for (const HubEntry& entry : labelling_.label(corner)) {
    CornerCost& from_root = from_root_[entry.hub];
    if (from_root == kUnreachedCost) hubs_.push_back(entry.hub);
    from_root = std::min(from_root, cost + entry.cost);
  }
  reach({cost, corner, kNone});
}

void SampledTrees::spread() {
  while (!frontier_.empty()) {
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

void SampledTrees::reach(const CornerFrontier::Entry& entry) {
  if (!labelling_.is_hub(entry.corner)) frontier_.reach(entry);
}

void SampledTrees::link(std::uint32_t node) {
  Node& linked = nodes_[node];
  linked.same_corner = first_nodes_[linked.corner];
  first_nodes_[linked.corner] = node;
  if (linked.parent == kNone) return;
  linked.sibling = nodes_[linked.parent].child;
  nodes_[linked.parent].child = node;
}

void SampledTrees::cut(std::uint32_t corner) {
  for (std::uint32_t root = first_nodes_[corner]; root != kNone; root = nodes_[root].same_corner) {
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

void SampledTrees::drop_cut_nodes() {
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

}  // namespace wend
