#pragma once

// JumpNodes: the search nodes of a jump point search, one for each jump point.
//
// A node's stamp says in one number which search reached it and at what cost: later searches have
// smaller stamps, and within a search cheaper paths have smaller stamps. So one comparison tells whether
// a path is better, and starting a search takes no time. When the numbers of searches run out, all nodes
// are cleared once and the numbers start again.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "wend/base/large_pages.hpp"
#include "wend/base/state_id.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/jump/jump_graph.hpp"

namespace wend {

template <class Cost, std::uint32_t kSearches = std::numeric_limits<std::uint32_t>::max()>
class JumpNodes {
 public:
  __extension__ using TwiceSixtyFour = unsigned __int128;
  using Stamp = std::conditional_t<sizeof(Cost) == 4, std::uint64_t, TwiceSixtyFour>;

  /// A node never lies in two cache lines.
  struct alignas(32) Node {
    Stamp stamp = kNever;
    Cell cell;
    StateId parent = 0;
    Jump first;                  // on the path from the parent
    std::uint32_t dead_end = 0;  // its number
    std::uint8_t pending = 0;    // arrivals to be expanded, one bit each
    std::uint8_t done = 0;       // arrivals already expanded, at the same cost

    Cost g() const { return static_cast<Cost>(stamp); }
  };

  /// `most`: how many there may be after resize() without a copy of all.
  explicit JumpNodes(std::size_t count, std::size_t most = 0) {
    nodes_.reserve(std::max(count, most));
    nodes_.resize(count);
  }

  std::size_t size() const { return nodes_.size(); }
  Node& operator[](StateId id) { return nodes_[id]; }
  const Node& operator[](StateId id) const { return nodes_[id]; }

  void resize(std::size_t count) { nodes_.resize(count); }

  /// Forgets the last search.
  void begin_search() {
    if (searches_left_ == 0) {
      for (Node& node : nodes_) node.stamp = kNever;
      searches_left_ = kSearches;
    }
    base_ = Stamp{--searches_left_} << kCostBits;
  }

  /// The stamp of a node that this search reaches at this cost.
  Stamp stamp(Cost g) const { return base_ | g; }

  /// Was it reached in this search?
  bool reached(const Node& node) const { return node.stamp >> kCostBits == base_ >> kCostBits; }

 private:
  static constexpr unsigned kCostBits = 8 * sizeof(Cost);
  static constexpr Stamp kNever = ~Stamp{0};

  std::vector<Node, LargePages<Node>> nodes_;
  std::uint32_t searches_left_ = kSearches;
  Stamp base_ = 0;
};

}  // namespace wend
