#include "wend/index/hub_labels/hub_labelling.hpp"

#include <algorithm>

namespace wend {

HubLabelling::HubLabelling(const CornerGraph& graph)
    : graph_(graph),
      is_hub_(graph.size()),
      labels_(graph.size()),
      from_root_(graph.size(), kUnreachedCost),
      frontier_(graph.size()) {}

void HubLabelling::add_hub(std::uint32_t corner) {
  const auto hub = static_cast<std::uint32_t>(hubs());
  hub_corners_.push_back(corner);
  is_hub_[corner] = 1;
  // What add_hub() appends to the label of `corner` itself comes last and is not in here.
  const std::vector<HubEntry> before = labels_[corner];
  for (const HubEntry& entry : before) from_root_[entry.hub] = entry.cost;
  spread(hub, corner);
  for (const HubEntry& entry : before) from_root_[entry.hub] = kUnreachedCost;
  frontier_.clear();
  trees_.push_back(nodes_.size());
}

void HubLabelling::spread(std::uint32_t hub, std::uint32_t root) {
  const std::size_t tree = nodes_.size();
  reach({0, root, HubTreeNode::kRoot});
  while (!frontier_.empty()) {
    const CornerFrontier::Entry next = frontier_.pop();
    if (frontier_.is_outdated(next)) continue;
    if (covers(labels_[next.corner], from_root_, next.cost)) continue;
    const auto place = static_cast<std::uint32_t>(nodes_.size() - tree);
    nodes_.push_back({next.corner, next.parent});
    labels_[next.corner].push_back({hub, next.cost});
    for (const CornerEdge edge : graph_.edges(next.corner)) {
      if (!is_hub(edge.to)) reach({next.cost + edge.cost, edge.to, place});
    }
  }
}

void HubLabelling::reach(const CornerFrontier::Entry& entry) {
  greatest_cost_ = std::max(greatest_cost_, entry.cost);
  frontier_.reach(entry);
}

}  // namespace wend
