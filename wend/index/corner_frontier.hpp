#pragma once

// CornerFrontier: what Dijkstra's algorithm has reached of the corner graph and not yet settled.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/index/corner_cost.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {

class CornerFrontier {
 public:
  struct Entry {
    CornerCost cost;
    std::uint32_t corner;
    std::uint32_t parent;  // whatever who asks calls it by

    friend bool operator<(const Entry& a, const Entry& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.corner < b.corner;
    }
  };

  explicit CornerFrontier(std::size_t corners) : costs_(corners, kUnreachedCost) {}

  /// Takes what is cheaper than all that came to the corner before.
  void reach(const Entry& entry) {
    CornerCost& cost = costs_[entry.corner];
    if (entry.cost >= cost) return;
    if (cost == kUnreachedCost) reached_.push_back(entry.corner);
    cost = entry.cost;
    min_heap::push(heap_, entry);
  }

  bool empty() const { return heap_.empty(); }

  /// The cheapest one; not of an empty frontier.
  Entry pop() { return min_heap::pop(heap_); }

  /// Did something cheaper come to the corner later?
  bool is_outdated(const Entry& entry) const { return entry.cost > costs_[entry.corner]; }

  /// Forgets all. O(reached).
  void clear() {
    for (const std::uint32_t corner : reached_) costs_[corner] = kUnreachedCost;
    reached_.clear();
    heap_.clear();
  }

 private:
  std::vector<CornerCost> costs_;  // by corner
  std::vector<std::uint32_t> reached_;
  std::vector<Entry> heap_;
};

}  // namespace wend
