// Totals of a SampledForest beside those of a forest that sums anew each time.

#include "wend/index/sampled_forest.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

/// All nodes ever added, with what was cut.
struct PlainForest {
  struct Node {
    std::uint32_t corner;
    int parent;
    std::uint64_t weight;
    bool cut;
  };

  void cut(std::uint32_t corner) {
    for (Node& node : nodes) {
      const bool below = node.parent >= 0 && nodes[static_cast<std::size_t>(node.parent)].cut;
      node.cut = node.cut || node.corner == corner || below;
    }
  }

  std::uint64_t total(std::uint32_t corner) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].corner == corner && !nodes[i].cut) sum += below(static_cast<int>(i));
    }
    return sum;
  }

  std::uint64_t below(int root) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].cut) continue;
      int up = static_cast<int>(i);
      while (up >= 0 && up != root) up = nodes[static_cast<std::size_t>(up)].parent;
      if (up == root) sum += nodes[i].weight;
    }
    return sum;
  }

  std::size_t size() const {
    std::size_t alive = 0;
    for (const Node& node : nodes) alive += node.cut ? 0 : 1;
    return alive;
  }

  std::vector<Node> nodes;
};

/// A tree of some of the corners, each once, with random parents.
void grow(SampledForest& forest, PlainForest& plain, std::uint32_t corners, Random& random) {
  forest.begin_tree();
  std::vector<std::uint32_t> numbers;
  const std::size_t first = plain.nodes.size();
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    if (random.chance(0.4)) continue;
    const std::size_t parent = numbers.empty() ? 0 : random.below(numbers.size());
    const auto weight = static_cast<std::uint32_t>(random.between(1, 9));
    const int above = numbers.empty() ? -1 : static_cast<int>(first + parent);
    plain.nodes.push_back({corner, above, weight, false});
    numbers.push_back(
        forest.add(corner, numbers.empty() ? SampledForest::kNone : numbers[parent], weight));
  }
  std::size_t told = 0;
  EXPECT_EQ(forest.end_tree([&](std::uint32_t) { ++told; }), numbers.size());
  EXPECT_EQ(told, numbers.size());
}

TEST(SampledForest, TotalsAreTheWeightsOfWhatIsLeft) {
  for (int seed = 1; seed <= test::share_of(200) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const auto corners = static_cast<std::uint32_t>(random.between(1, 8));
    SampledForest forest(corners);
    PlainForest plain;
    for (int change = 0; change < 20; ++change) {
      if (random.chance(0.5)) {
        grow(forest, plain, corners, random);
      } else {
        const auto corner = static_cast<std::uint32_t>(random.below(corners));
        forest.cut(corner);
        plain.cut(corner);
      }
      ASSERT_EQ(forest.size(), plain.size());
      for (std::uint32_t corner = 0; corner < corners; ++corner) {
        ASSERT_EQ(forest.total(corner), plain.total(corner)) << corner;
      }
    }
  }
}

}  // namespace
}  // namespace wend
