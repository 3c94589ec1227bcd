#pragma once

// The search nodes. Each holds a state's g, how it was reached (its arrival), and whether it is closed.
// Two kinds of nodes:
//
// - MoveNode: the arrival is a move, which the space can undo. The smallest.
// - ParentNode: the arrival is the parent, any state of the space.
//
// A store keeps the nodes of all states. NodeTable has room for every state: the fastest. Its memory comes
// zeroed from the system, and most systems allocate pages only for states that are touched. PagedNodes
// (paged_nodes.hpp) allocates them itself, for the states that a search reaches.
//
// Starting a search takes O(1): a node is valid only if its generation is the current one. When the
// generations run out, the store is cleared once and they start again.

#include <cstdint>
#include <cstdlib>
#include <memory>

#include "wend/base/state_id.hpp"
#include "wend/base/zeroed_memory.hpp"

namespace wend {

/// 8 bytes with a 32-bit cost, 16 with a 64-bit one.
template <class Cost>
class MoveNode {
 public:
  using Arrival = Move;
  static constexpr Arrival kNoArrival = kNoMove;  // of a start

  Cost g;

  Arrival arrival() const { return static_cast<Arrival>(tag_ & kMoveMask); }
  bool closed() const { return (tag_ & kClosed) != 0; }
  void close() { tag_ |= kClosed; }

 private:
  template <class Node, unsigned kGenerationBits>
  friend class NodeGenerations;

  static constexpr std::uint32_t kMoveMask = (1U << kMoveBits) - 1;
  static constexpr std::uint32_t kClosed = 1U << kMoveBits;
  static constexpr std::uint32_t kFlags = kMoveMask | kClosed;

  void open(std::uint32_t generation, Cost cost, Arrival move) {
    g = cost;
    tag_ = generation | move;
  }

  // From bit 0: the arrival, closed, the generation. 0: a node without a generation.
  std::uint32_t tag_;
};

/// 16 bytes with a 64-bit cost.
template <class Cost>
class ParentNode {
 public:
  using Arrival = StateId;
  static constexpr Arrival kNoArrival = ~StateId{0};  // of a start

  Cost g;

  Arrival arrival() const { return parent_; }
  bool closed() const { return (tag_ & kClosed) != 0; }
  void close() { tag_ |= kClosed; }

  /// Another way to the same state.
  void replace(Cost cost, Arrival parent) {
    g = cost;
    parent_ = parent;
  }

 private:
  template <class Node, unsigned kGenerationBits>
  friend class NodeGenerations;

  static constexpr std::uint32_t kClosed = 1;
  static constexpr std::uint32_t kFlags = kClosed;

  void open(std::uint32_t generation, Cost cost, Arrival parent) {
    replace(cost, parent);
    tag_ = generation;
  }

  StateId parent_;
  std::uint32_t tag_;  // bit 0: closed; then the generation, 0 for a node without one
};

/// Which nodes of a store belong to the current search.
template <class Node, unsigned kGenerationBits>
class NodeGenerations {
 public:
  /// Invalidates all nodes; calls clear(invalidate), which is to invalidate each of them, when the
  /// generations run out.
  template <class Clear>
  void advance(Clear&& clear) {
    current_ += kUnit;
    if (current_ < kEnd) return;
    clear([](Node& node) { node.tag_ = 0; });
    current_ = kUnit;
  }

  bool is_current(const Node& node) const { return (node.tag_ & ~Node::kFlags) == current_; }

  void open(Node& node, decltype(Node::g) g, typename Node::Arrival arrival) const {
    node.open(static_cast<std::uint32_t>(current_), g, arrival);
  }

 private:
  static constexpr std::uint64_t kUnit = Node::kFlags + 1;
  static constexpr std::uint64_t kEnd = kUnit << kGenerationBits;

  std::uint64_t current_ = 0;
};

inline constexpr unsigned kNodeGenerationBits = 32 - kMoveBits - 1;

template <class NodeType, unsigned kGenerationBits = kNodeGenerationBits>
class NodeTable {
 public:
  using Node = NodeType;
  static constexpr bool kGrows = false;

  explicit NodeTable(StateId count)
      : count_(count), nodes_(static_cast<Node*>(std::calloc(count, sizeof(Node)))) {}

  /// False if the system had no memory for the table.
  bool allocated() const { return nodes_ != nullptr; }

  /// Invalidates all nodes. O(1) except when generations run out.
  void begin_search() {
    generations_.advance([this](auto&& invalidate) {
      for (StateId id = 0; id < count_; ++id) invalidate(nodes_[id]);
    });
  }

  Node& operator[](StateId id) { return nodes_[id]; }
  const Node& operator[](StateId id) const { return nodes_[id]; }

  /// The node to open for a state.
  Node* room_for(StateId id) { return &nodes_[id]; }

  /// Prefetches a node. Any id is allowed, even one that is not a state.
  void prefetch(StateId id) const {
    // The address is a number here: it may lie outside the table.
    const auto address = reinterpret_cast<std::uintptr_t>(nodes_.get()) + id * sizeof(Node);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): a pointer outside the table must not be computed
    __builtin_prefetch(reinterpret_cast<const void*>(address), 1);
  }

  /// Has this search reached the node?
  bool reached(const Node& node) const { return generations_.is_current(node); }

  /// Opens a node, for the first time or again.
  void open(Node& node, decltype(Node::g) g, typename Node::Arrival arrival) {
    generations_.open(node, g, arrival);
  }

 private:
  StateId count_;
  NodeGenerations<Node, kGenerationBits> generations_;
  std::unique_ptr<Node[], FreeMemory> nodes_;
};

/// The store of most searches, by a name with one parameter.
template <class Node>
using DenseNodes = NodeTable<Node>;

}  // namespace wend
