#pragma once

// DisjointSets: which elements have been joined.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace wend {

/// Union-find in an array of parents, in which a root is its own: the root of a set; halves the path to it.
template <class Parents, class Index>
Index root_in(Parents& parents, Index set) {
  while (parents[set] != set) {
    parents[set] = parents[parents[set]];
    set = parents[set];
  }
  return set;
}

/// Joins two sets. The smaller root wins.
template <class Parents, class Index>
void join_in(Parents& parents, Index a, Index b) {
  a = root_in(parents, a);
  b = root_in(parents, b);
  parents[std::max(a, b)] = std::min(a, b);
}

/// Union-find with path halving. The smaller root wins, so that sets are numbered in the order in which
/// they were added. Almost O(1) for each call.
class DisjointSets {
 public:
  /// `count` sets of one element each.
  explicit DisjointSets(std::uint32_t count = 0) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
  }

  std::uint32_t add() {
    parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
    return parents_.back();
  }

  std::uint32_t root(std::uint32_t set) { return root_in(parents_, set); }
  void join(std::uint32_t a, std::uint32_t b) { join_in(parents_, a, b); }

  std::size_t size() const { return parents_.size(); }

  /// A number for every set: 0, 1, 2, ... in the order of their roots.
  std::vector<std::uint32_t> numbered() {
    std::vector<std::uint32_t> numbers(size());
    std::uint32_t next = 0;
    for (std::uint32_t set = 0; set < size(); ++set) {
      const std::uint32_t its_root = root(set);
      numbers[set] = its_root == set ? next++ : numbers[its_root];
    }
    return numbers;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace wend
