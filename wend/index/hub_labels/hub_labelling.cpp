#include "wend/index/hub_labels/hub_labelling.hpp"

namespace wend {

HubLabelling::HubLabelling(const CornerGraph& graph, const IndexBuilding& building)
    : graph_(graph),
      building_(building),
      is_hub_(graph.size()),
      labels_(graph.size()),
      from_root_(graph.size(), kUnreachedCost),
      frontier_(graph.size()) {}

void HubLabelling::add_hub(std::uint32_t corner) {
  const auto hub = static_cast<std::uint32_t>(hubs());
  hub_corners_.push_back(corner);
  is_hub_[corner] = 1;
  // This copy does not contain the last entry, which add_hub() appends to the label of `corner` itself.
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
  while (!frontier_.empty() && !building_.cancelled()) {
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

ComponentHubs::ComponentHubs(const Corners& corners, const HubLabelling& labelling)
    : corners_(corners), labelling_(labelling), slots_(labelling.hubs(), kNone) {}

std::span<const std::vector<HubEntry>> ComponentHubs::choose(std::span<const Cell> cells,
                                                             std::span<const std::uint32_t> first) {
  list_hubs(first);
  for (const Cell cell : cells) {
    reach_hubs(cell, first);
    keep_what_is_needed(cell, first);
  }
  if (chosen_.size() < first.size()) chosen_.resize(first.size());
  for (std::vector<HubEntry>& chosen : chosen_) chosen.clear();
  for (std::size_t slot = 0; slot < hubs_.size(); ++slot) {
    for (const Reached& kept : kept_by_[slot]) {
      chosen_[kept.by].push_back({hubs_[slot], kept.from_corner});
    }
    slots_[hubs_[slot]] = kNone;
  }
  return std::span(chosen_).first(first.size());
}

void ComponentHubs::list_hubs(std::span<const std::uint32_t> first) {
  hubs_.clear();
  for (const std::uint32_t corner : first) {
    for (const HubEntry& entry : labelling_.label(corner)) {
      if (slots_[entry.hub] == kNone) hubs_.push_back(entry.hub);
      slots_[entry.hub] = 0;
    }
  }
  std::sort(hubs_.begin(), hubs_.end());
  for (std::uint32_t slot = 0; slot < hubs_.size(); ++slot) slots_[hubs_[slot]] = slot;
  reached_.resize(hubs_.size());
  if (kept_by_.size() < hubs_.size()) kept_by_.resize(hubs_.size());
  for (std::size_t slot = 0; slot < hubs_.size(); ++slot) kept_by_[slot].clear();
}

void ComponentHubs::reach_hubs(Cell cell, std::span<const std::uint32_t> first) {
  std::fill(reached_.begin(), reached_.end(), Reached{kUnreachedCost, 0, 0});
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const auto to_corner = octile_cost<CornerCost>(cell, corners_.cell(first[i]));
    for (const HubEntry& entry : labelling_.label(first[i])) {
      Reached& reached = reached_[slots_[entry.hub]];
      const CornerCost cost = to_corner + entry.cost;
      if (cost < reached.cost) reached = {cost, entry.cost, i};
    }
  }
}

void ComponentHubs::keep_what_is_needed(Cell cell, std::span<const std::uint32_t> first) {
  for (std::size_t slot = 0; slot < hubs_.size(); ++slot) {
    if (is_kept(cell, first, slot) || !is_needed(slot)) continue;
    kept_by_[slot].push_back(reached_[slot]);
  }
}

bool ComponentHubs::is_kept(Cell cell, std::span<const std::uint32_t> first,
                            std::size_t slot) const {
  return std::any_of(kept_by_[slot].begin(), kept_by_[slot].end(), [&](const Reached& kept) {
    const auto to_corner = octile_cost<CornerCost>(cell, corners_.cell(first[kept.by]));
    return to_corner + kept.from_corner == reached_[slot].cost;
  });
}

bool ComponentHubs::is_needed(std::size_t slot) const {
  for (const HubEntry& entry : labelling_.label(labelling_.corner_of(hubs_[slot]))) {
    if (entry.hub == hubs_[slot]) break;
    const std::uint32_t more_important = slots_[entry.hub];
    if (more_important == kNone) continue;
    if (reached_[more_important].cost + entry.cost <= reached_[slot].cost) return false;
  }
  return true;
}

}  // namespace wend
