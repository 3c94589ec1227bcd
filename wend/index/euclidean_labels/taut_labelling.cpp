#include "wend/index/euclidean_labels/taut_labelling.hpp"

#include <algorithm>

namespace wend {

TautLabelling::TautLabelling(const TautGraph& graph)
    : graph_(graph),
      tree_(graph),
      hubs_(graph.portals().corners().size(), kNone),
      labels_(hubs_.size()),
      from_root_(hubs_.size(), kUnreached) {}

void TautLabelling::add_hub(std::uint32_t corner) {
  const std::uint32_t hub = hubs();
  corners_.push_back(corner);
  hubs_[corner] = hub;
  for (const Known& known : labels_[corner]) from_root_[known.hub] = known.length;
  tree_.spread(corner, [&](const TautTree::Reached& at) {
    if (is_covered(at)) return false;
    const std::uint32_t before = tree_.before(at.edge);
    const std::uint32_t next = before == corner ? kNone : labels_[before].back().entry;
    const auto entry = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({at.corner, hub, graph_.edge(at.edge).back, next, at.length});
    labels_[at.corner].push_back({hub, entry, at.length});
    return true;
  });
  for (const Known& known : labels_[corner]) from_root_[known.hub] = kUnreached;
}

/// Does an earlier hub give a path that is no longer?
bool TautLabelling::is_covered(const TautTree::Reached& at) const {
  const double most = at.length + kRounding;
  if (hubs_[at.corner] != kNone && from_root_[hubs_[at.corner]] <= most) return true;
  return std::ranges::any_of(labels_[at.corner], [&](const Known& known) {
    return from_root_[known.hub] + known.length <= most;
  });
}

}  // namespace wend
