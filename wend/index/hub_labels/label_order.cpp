#include "wend/index/hub_labels/label_order.hpp"

#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::size_t kFirstTrees = 16;
constexpr std::size_t kNodesPerCorner = 16;
constexpr double kFewNodes = 20;        // a tree
constexpr double kMemoryOfMean = 0.99;  // of the running mean

}  // namespace

LabelOrder::LabelOrder(const CornerGraph& graph, const AllFirstCorners& first,
                       const HubLabelling& labelling)
    : labelling_(labelling),
      trees_(graph, first, labelling),
      wanted_nodes_(kNodesPerCorner * graph.size()),
      nodes_of_late_(static_cast<double>(graph.size())),
      queued_(graph.size()) {}

std::uint32_t LabelOrder::next() {
  grow_trees();
  while (!queue_.empty()) {
    const Candidate best = min_heap::pop(queue_);
    if (best.total != queued_[best.corner]) continue;  // it was queued again, with more
    queued_[best.corner] = 0;
    const std::uint64_t total = trees_.total(best.corner);
    if (total == best.total) {
      trees_.cut(best.corner);
      return best.corner;
    }
    if (total > 0) push(best.corner, total);
  }
  while (labelling_.is_hub(rest_)) ++rest_;
  return rest_;
}

void LabelOrder::grow_trees() {
  while (!all_told_ && (grown_ < kFirstTrees || trees_.size() < wanted_nodes_)) {
    const std::size_t nodes = trees_.grow([&](std::uint32_t corner) {
      const std::uint64_t total = trees_.total(corner);
      // With room to grow, so that not every tree queues it again.
      if (total > queued_[corner]) push(corner, total + total / 4);
    });
    ++grown_;
    nodes_of_late_ =
        kMemoryOfMean * nodes_of_late_ + (1 - kMemoryOfMean) * static_cast<double>(nodes);
    all_told_ = nodes_of_late_ < kFewNodes;
  }
}

void LabelOrder::push(std::uint32_t corner, std::uint64_t total) {
  queued_[corner] = total;
  min_heap::push(queue_, {total, corner});
}

}  // namespace wend
