#include "wend/index/hub_labels/component_hubs.hpp"

#include <algorithm>

namespace wend {

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
