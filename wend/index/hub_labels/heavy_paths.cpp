#include "wend/index/hub_labels/heavy_paths.hpp"

#include <algorithm>
#include <cstdlib>
#include <ranges>

namespace wend {
namespace {

constexpr std::uint32_t kNone = HubTreeNode::kRoot;
constexpr unsigned kHalf = 16;  // bits

}  // namespace

HeavyPaths::HeavyPaths(const Corners& corners, const HubLabelling& labelling)
    : corners_(corners), begins_{0} {
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    begins_.push_back(begins_.back() + labelling.label(corner).size());
  }
  places_.resize(begins_.back());
  next_ = begins_;
  for (std::uint32_t hub = 0; hub < labelling.hubs(); ++hub) add_tree(labelling.tree(hub));
  add_joint(0);  // the end, behind which nobody reads
}

void HeavyPaths::add_tree(std::span<const HubTreeNode> tree) {
  below_.assign(tree.size(), 1);
  heavy_.assign(tree.size(), kNone);
  starts_.resize(tree.size());
  for (auto node = static_cast<std::uint32_t>(tree.size()); node-- > 1;) {
    const std::uint32_t parent = tree[node].parent;
    below_[parent] += below_[node];
    std::uint32_t& heavy = heavy_[parent];
    if (heavy == kNone || below_[node] > below_[heavy]) heavy = node;
  }
  starts_[0] = run_word::kHub;
  for (std::uint32_t node = 1; node < tree.size(); ++node) {
    const std::uint32_t parent = tree[node].parent;
    if (parent == 0 || heavy_[parent] != node) add_path(tree, node);
  }
  for (std::uint32_t node = 0; node < tree.size(); ++node) {
    places_[next_[tree[node].corner]++] = starts_[node];
  }
}

void HeavyPaths::add_path(std::span<const HubTreeNode> tree, std::uint32_t top) {
  path_.clear();
  for (std::uint32_t node = top; node != kNone; node = heavy_[node]) path_.push_back(node);
  for (const std::uint32_t node : path_ | std::views::reverse) {
    starts_[node] = static_cast<std::uint32_t>(words_.size());
    add_way(corners_.cell(tree[node].corner), corners_.cell(tree[tree[node].parent].corner));
  }
  add_joint(starts_[tree[top].parent]);
}

void HeavyPaths::add_way(Cell from, Cell to) {
  while (from != to) {
    const Cell way{to.x - from.x, to.y - from.y};
    const Cell sign{(way.x > 0) - (way.x < 0), (way.y > 0) - (way.y < 0)};
    const int wide = std::abs(way.x);
    const int high = std::abs(way.y);
    const int length = sign.x != 0 && sign.y != 0 ? std::min(wide, high) : std::max(wide, high);
    const int steps = std::min(length, run_word::kMostSteps);
    words_.push_back(run_word::of(steps, direction_of(sign)));
    from = {from.x + steps * sign.x, from.y + steps * sign.y};
  }
}

void HeavyPaths::add_joint(std::uint32_t place) {
  words_.push_back(run_word::kJoint);
  words_.push_back(static_cast<RunWord>(place));
  words_.push_back(static_cast<RunWord>(place >> kHalf));
}

}  // namespace wend
