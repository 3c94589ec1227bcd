#include "wend/index/sampled_forest.hpp"

#include <algorithm>

namespace wend {

void SampledForest::begin_tree() {
  if (nodes_.size() > 2 * alive_ + totals_.size()) drop_cut_nodes();
  begin_ = nodes_.size();
}

std::uint32_t SampledForest::add(std::uint32_t corner, std::uint32_t parent, std::uint32_t weight) {
  nodes_.push_back({.corner = corner, .parent = parent, .weight = weight});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void SampledForest::sum_weights() {
  alive_ += nodes_.size() - begin_;
  for (std::size_t i = nodes_.size(); i-- > begin_;) {
    const Node& node = nodes_[i];
    totals_[node.corner] += node.weight;
    if (node.parent != kNone) nodes_[node.parent].weight += node.weight;
    link(static_cast<std::uint32_t>(i));
  }
}

void SampledForest::link(std::uint32_t node) {
  Node& linked = nodes_[node];
  linked.same_corner = first_nodes_[linked.corner];
  first_nodes_[linked.corner] = node;
  if (linked.parent == kNone) return;
  linked.sibling = nodes_[linked.parent].child;
  nodes_[linked.parent].child = node;
}

void SampledForest::cut(std::uint32_t corner) {
  for (std::uint32_t root = first_nodes_[corner]; root != kNone; root = nodes_[root].same_corner) {
    const std::uint32_t weight = nodes_[root].weight;
    if (weight == 0) continue;
    for (std::uint32_t up = nodes_[root].parent; up != kNone; up = nodes_[up].parent) {
      nodes_[up].weight -= weight;
      totals_[nodes_[up].corner] -= weight;
    }
    cut_subtree(root);
  }
  first_nodes_[corner] = kNone;
}

void SampledForest::cut_subtree(std::uint32_t root) {
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

/// The parent of a node that is left is left too.
void SampledForest::drop_cut_nodes() {
  std::vector<std::uint32_t> places(nodes_.size());
  std::ranges::fill(first_nodes_, kNone);
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
