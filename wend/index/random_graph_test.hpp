#pragma once

// Random directed graphs, and their shortest paths by brute force, for the tests of contraction.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/index/corner_hierarchy/graph_contraction.hpp"

namespace wend::test {

inline constexpr std::uint64_t kNoWay = std::numeric_limits<std::uint32_t>::max();

struct RandomGraph {
  std::uint32_t nodes = 0;
  std::vector<GraphArc> arcs;

  /// Makes a sparse or dense graph with cheap arcs (so that many paths cost the same) or expensive ones;
  /// some arcs are parallel.
  explicit RandomGraph(std::uint64_t seed) {
    Random random(seed);
    nodes = static_cast<std::uint32_t>(random.between(1, 24));
    const int count = random.between(0, static_cast<int>(nodes) * random.between(1, 5));
    const std::uint64_t dearest = random.chance(0.5) ? 4 : 1'000'000;
    for (int i = 0; i < count; ++i) {
      const auto tail = static_cast<std::uint32_t>(random.below(nodes));
      const auto head = static_cast<std::uint32_t>(random.below(nodes));
      const auto cost = static_cast<HierarchyCost>(1 + random.below(dearest));
      if (tail != head) arcs.push_back({tail, head, cost});
    }
  }

  /// The cost of all arcs; no shortest path costs more.
  std::uint64_t total_cost() const {
    std::uint64_t total = 0;
    for (const GraphArc& arc : arcs) total += arc.cost;
    return total;
  }

  /// Between all pairs, by the Floyd-Warshall algorithm.
  std::vector<std::vector<std::uint64_t>> distances() const {
    std::vector<std::vector<std::uint64_t>> costs(nodes, std::vector(nodes, kNoWay));
    for (std::uint32_t node = 0; node < nodes; ++node) costs[node][node] = 0;
    for (const auto& [tail, head, cost] : arcs) {
      costs[tail][head] = std::min<std::uint64_t>(costs[tail][head], cost);
    }
    for (std::uint32_t middle = 0; middle < nodes; ++middle) {
      for (std::uint32_t tail = 0; tail < nodes; ++tail) {
        for (std::uint32_t head = 0; head < nodes; ++head) {
          costs[tail][head] =
              std::min(costs[tail][head], costs[tail][middle] + costs[middle][head]);
        }
      }
    }
    return costs;
  }

  /// The cost of a path; kNoWay if an arc is missing.
  std::uint64_t cost_of(const std::vector<std::uint32_t>& path) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      std::uint64_t least = kNoWay;
      for (const auto& [tail, head, cost] : arcs) {
        if (tail == path[i - 1] && head == path[i]) least = std::min<std::uint64_t>(least, cost);
      }
      if (least == kNoWay) return kNoWay;
      sum += least;
    }
    return sum;
  }
};

}  // namespace wend::test
