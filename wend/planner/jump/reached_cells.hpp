#pragma once

// ReachedCells: the nodes of a search that reaches few of a map's cells, numbered as they are reached.
//
// A hash table finds the number of a cell. Clearing takes the time of the nodes there were.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/base/large_pages.hpp"
#include "wend/base/state_id.hpp"
#include "wend/geometry/cell.hpp"

namespace wend {

/// Node has a member `cell`.
template <class Node>
class ReachedCells {
 public:
  Node& operator[](StateId id) { return nodes_[id]; }
  const Node& operator[](StateId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }

  void clear() {
    for (const std::size_t slot : used_) slots_[slot] = kNone;
    used_.clear();
    nodes_.clear();
  }

  /// The number of the node at a cell, which is added if it is not there. References to nodes are lost then.
  StateId at(Cell cell) {
    if (2 * nodes_.size() >= slots_.size()) grow();
    const std::size_t slot = slot_of(cell);
    if (slots_[slot] == kNone) {
      slots_[slot] = static_cast<StateId>(nodes_.size());
      used_.push_back(slot);
      nodes_.emplace_back().cell = cell;
    }
    return slots_[slot];
  }

 private:
  static constexpr StateId kNone = ~StateId{0};

  /// The slot of a cell, or the empty one where it belongs.
  std::size_t slot_of(Cell cell) const {
    const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(cell.y)} << 32U |
                              static_cast<std::uint32_t>(cell.x);
    auto slot = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> shift_);
    while (slots_[slot] != kNone && nodes_[slots_[slot]].cell != cell) {
      slot = slot + 1 == slots_.size() ? 0 : slot + 1;
    }
    return slot;
  }

  [[gnu::noinline]] void grow() {
    const std::size_t size = slots_.empty() ? 64 : 4 * slots_.size();
    shift_ = 64 - std::countr_zero(size);
    slots_.assign(size, kNone);
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
      used_[id] = slot_of(nodes_[id].cell);
      slots_[used_[id]] = static_cast<StateId>(id);
    }
  }

  std::vector<Node, LargePages<Node>> nodes_;
  std::vector<StateId, LargePages<StateId>> slots_;  // at least twice as many
  std::vector<std::size_t> used_;                    // by node: its slot
  int shift_ = 63;
};

}  // namespace wend
