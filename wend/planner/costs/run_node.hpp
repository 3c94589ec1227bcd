#pragma once

// RunNode: the node of a search that leaps: it keeps the move by which a cell was reached, and how many
// times that move was made without a stop.

#include <cstdint>

#include "wend/base/state_id.hpp"
#include "wend/search/node_table.hpp"

namespace wend {

/// 8 bytes with a 32-bit cost, 16 with a 64-bit one.
template <class Cost>
class RunNode {
 public:
  /// A Move in the lowest bits, then the length of the run.
  using Arrival = std::uint32_t;
  static constexpr std::uint32_t kLongest = (1U << 12U) - 1;  // cells of a run
  static constexpr Arrival kNoArrival = kNoMove;              // of a start

  static constexpr Arrival arrival_by(unsigned move, std::uint32_t run) {
    return move | run << kMoveBits;
  }

  Cost g;

  Move move() const { return static_cast<Move>(tag_ & kNoMove); }
  std::uint32_t run() const { return (tag_ & kFlags) >> kMoveBits; }

 private:
  template <class Node, unsigned kGenerationBits>
  friend class NodeGenerations;

  static constexpr std::uint32_t kFlags = 0xFFFF;

  void open(std::uint32_t generation, Cost cost, Arrival arrival) {
    g = cost;
    tag_ = generation | arrival;
  }

  // From bit 0: the arrival, then the generation. 0: a node without a generation.
  std::uint32_t tag_;
};

template <class Cost>
using RunNodes = NodeTable<RunNode<Cost>, 16>;

}  // namespace wend
