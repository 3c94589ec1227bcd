#pragma once

// HashedNodes: search nodes in a hash table, with room for the states that searches reach. For spaces with
// many states of which a search needs few, far from each other; where they lie together, PagedNodes are
// faster. See node_table.hpp for the nodes.
//
// Open addressing with linear probing. A slot whose node is not of the current search counts as empty, so
// a search starts in O(1) and nothing is ever deleted. The table is at most half full; it doubles, and
// keeps its size for later searches. Growing moves the nodes: room_for() invalidates references to them.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <utility>

#include "wend/search/node_table.hpp"

namespace wend {

template <class NodeType, unsigned kGenerationBits = kNodeGenerationBits>
class HashedNodes {
 public:
  using Node = NodeType;
  static constexpr bool kGrows = true;

  /// For any number of states.
  explicit HashedNodes(StateId /*count*/ = 0) : slots_(zeroed(kFirstSlots)) {}

  /// False if the system had no memory for a small table.
  bool allocated() const { return slots_ != nullptr; }

  /// Invalidates all nodes. O(1) except when generations run out.
  void begin_search() {
    generations_.advance([this](auto&& invalidate) {
      for (std::size_t slot = 0; slot <= mask_; ++slot) invalidate(slots_[slot].node);
    });
    reached_ = 0;
  }

  /// The node of a state; one that is not reached() if this search has not reached the state.
  const Node& operator[](StateId id) const {
    const Slot& slot = slots_[slot_of(id)];
    return is_of(slot, id) ? slot.node : kUnreached;
  }
  /// For a state that this search has reached.
  Node& operator[](StateId id) { return slots_[slot_of(id)].node; }

  /// The node to open for a state; null if the table would have to grow and there is no memory.
  Node* room_for(StateId id) {
    if (2 * reached_ > mask_ && !grow()) return nullptr;
    Slot& slot = slots_[slot_of(id)];
    slot.id = id;
    return &slot.node;
  }

  /// Prefetches a node. Any id is allowed, even one that is not a state.
  void prefetch(StateId id) const { __builtin_prefetch(&slots_[home_of(id)], 1); }

  /// Has this search reached the node?
  bool reached(const Node& node) const { return generations_.is_current(node); }

  /// Opens a node, for the first time or again.
  void open(Node& node, decltype(Node::g) g, typename Node::Arrival arrival) {
    if (!reached(node)) ++reached_;
    generations_.open(node, g, arrival);
  }

 private:
  struct Slot {
    Node node;
    StateId id;
  };
  using Slots = std::unique_ptr<Slot[], FreeMemory>;

  static constexpr std::size_t kGroup = 16;
  static constexpr std::size_t kFirstSlots = 1024;
  static constexpr Node kUnreached{};

  static Slots zeroed(std::size_t count) {
    return Slots(static_cast<Slot*>(std::calloc(count, sizeof(Slot))));
  }

  bool is_of(const Slot& slot, StateId id) const { return reached(slot.node) && slot.id == id; }

  /// Fibonacci hashing: the upper bits of a product (D. Knuth, "The Art of Computer Programming", volume 3,
  /// section 6.4). Sixteen ids in a row, which are often the headings of one place, stay together.
  std::size_t home_of(StateId id) const {
    const auto group = static_cast<std::size_t>((id / kGroup * 0x9E3779B97F4A7C15U) >> shift_);
    return group * kGroup + id % kGroup;
  }

  /// Where a state is, or where it would be.
  std::size_t slot_of(StateId id) const {
    std::size_t slot = home_of(id);
    while (reached(slots_[slot].node) && slots_[slot].id != id) slot = (slot + 1) & mask_;
    return slot;
  }

  bool grow() {
    const std::size_t count = 2 * (mask_ + 1);
    Slots larger = zeroed(count);
    if (larger == nullptr) return false;
    const Slots old = std::exchange(slots_, std::move(larger));
    const std::size_t old_mask = std::exchange(mask_, count - 1);
    --shift_;
    for (std::size_t slot = 0; slot <= old_mask; ++slot) {
      if (reached(old[slot].node)) slots_[slot_of(old[slot].id)] = old[slot];
    }
    return true;
  }

  NodeGenerations<Node, kGenerationBits> generations_;
  Slots slots_;
  std::size_t mask_ = kFirstSlots - 1;
  int shift_ = 64 - std::countr_zero(kFirstSlots / kGroup);
  std::size_t reached_ = 0;  // states
};

}  // namespace wend
