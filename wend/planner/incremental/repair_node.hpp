#pragma once

// RepairNode: the node of a search whose tree is kept and repaired when the map changes. It can be forgotten,
// and marked to be expanded with all moves.

#include <cstdint>

#include "wend/base/state_id.hpp"
#include "wend/search/node_table.hpp"

namespace wend {

/// 8 bytes with a 32-bit cost, 16 with a 64-bit one.
template <class Cost>
class RepairNode {
 public:
  using Arrival = Move;
  static constexpr Arrival kNoArrival = kNoMove;  // of a root

  Cost g;

  Move arrival() const { return static_cast<Move>(tag_ & kNoMove); }

  bool closed() const { return (tag_ & kClosed) != 0; }
  void close() { tag_ |= kClosed; }
  void reopen() { tag_ &= ~kClosed; }

  /// Must it be expanded with all moves, because what lies around it has changed?
  bool marked() const { return (tag_ & kMarked) != 0; }
  void mark() { tag_ |= kMarked; }

  /// Makes it a node that the search has not reached.
  void forget() { tag_ = 0; }

 private:
  template <class Node, unsigned kGenerationBits>
  friend class NodeGenerations;

  static constexpr std::uint32_t kClosed = 1U << kMoveBits;
  static constexpr std::uint32_t kMarked = kClosed << 1U;
  static constexpr std::uint32_t kFlags = kNoMove | kClosed | kMarked;

  void open(std::uint32_t generation, Cost cost, Arrival move) {
    g = cost;
    tag_ = generation | move;
  }

  // From bit 0: the arrival, closed, marked, the generation. 0: a node without a generation.
  std::uint32_t tag_;
};

template <class Cost>
using RepairNodes = NodeTable<RepairNode<Cost>, 26>;

}  // namespace wend
