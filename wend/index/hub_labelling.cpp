#include "wend/index/hub_labelling.hpp"

#include <algorithm>

#include "wend/search/min_heap.hpp"

namespace wend {

HubLabelling::HubLabelling(const CornerGraph& graph)
    : graph_(graph),
      is_hub_(graph.size()),
      labels_(graph.size()),
      from_root_(graph.size(), kUnreachedCost),
      costs_(graph.size(), kUnreachedCost) {}

void HubLabelling::add_hub(std::uint32_t corner) {
  const auto hub = static_cast<std::uint32_t>(hubs());
  hub_corners_.push_back(corner);
  is_hub_[corner] = 1;
  // What add_hub() appends to the label of `corner` itself comes last and is not in here.
  const std::vector<HubEntry> before = labels_[corner];
  for (const HubEntry& entry : before) from_root_[entry.hub] = entry.cost;
  spread(hub, corner);
  for (const HubEntry& entry : before) from_root_[entry.hub] = kUnreachedCost;
  for (const std::uint32_t touched : reached_) costs_[touched] = kUnreachedCost;
  reached_.clear();
  trees_.push_back(nodes_.size());
}

void HubLabelling::spread(std::uint32_t hub, std::uint32_t root) {
  const std::size_t tree = nodes_.size();
  reach({0, root, HubTreeNode::kRoot});
  while (!queue_.empty()) {
    const Candidate next = min_heap::pop(queue_);
    if (next.cost > costs_[next.corner] || is_covered(next.corner, next.cost)) continue;
    const auto place = static_cast<std::uint32_t>(nodes_.size() - tree);
    nodes_.push_back({next.corner, next.parent});
    labels_[next.corner].push_back({hub, next.cost});
    for (const CornerEdge edge : graph_.edges(next.corner)) {
      if (!is_hub(edge.to)) reach({next.cost + edge.cost, edge.to, place});
    }
  }
}

void HubLabelling::reach(const Candidate& candidate) {
  greatest_cost_ = std::max(greatest_cost_, candidate.cost);
  CornerCost& cost = costs_[candidate.corner];
  if (candidate.cost >= cost) return;
  if (cost == kUnreachedCost) reached_.push_back(candidate.corner);
  cost = candidate.cost;
  min_heap::push(queue_, candidate);
}

bool HubLabelling::is_covered(std::uint32_t corner, CornerCost cost) const {
  return std::any_of(labels_[corner].begin(), labels_[corner].end(), [&](const HubEntry& entry) {
    return from_root_[entry.hub] + entry.cost <= cost;
  });
}

}  // namespace wend
