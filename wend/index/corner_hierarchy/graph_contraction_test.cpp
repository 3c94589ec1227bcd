// Contracts random graphs fully, partly or not at all, and searches them between all pairs.

#include "wend/index/corner_hierarchy/graph_contraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "tests/testing/share.hpp"
#include "wend/index/corner_hierarchy/hierarchy_search.hpp"
#include "wend/index/random_graph_test.hpp"

namespace wend {
namespace {

using test::kNoWay;
using test::RandomGraph;

constexpr std::uint64_t kGraphs = 300;
constexpr ContractionEffort kSmall{3, 5, 1'000'000};  // misses most witnesses
constexpr ContractionEffort kNothing{30, 60, 0};      // all is core
constexpr ContractionEffort kInPart{30, 60, 40};      // stops part-way
constexpr ContractionEffort kEfforts[] = {{}, kSmall, kNothing, kInPart};

ContractedGraph contracted(const RandomGraph& graph, const ContractionEffort& effort) {
  auto result = contract(graph.nodes, graph.arcs, effort, {});
  EXPECT_TRUE(result);
  return *std::move(result);
}

/// Single nodes, or some with their costs, and no estimates.
struct PlainQuery {
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> goals;

  HierarchyCost to_start(std::uint32_t /*node*/) const { return 0; }
  HierarchyCost to_goal(std::uint32_t /*node*/) const { return 0; }
  template <class Visit>
  void for_each_start(std::uint32_t i, Visit&& visit) const {
    visit(starts[i]);
  }
  template <class Visit>
  void for_each_goal(std::uint32_t i, Visit&& visit) const {
    visit(goals[i]);
  }
};

/// Estimates two thirds of the true distances from one node and to another, which is consistent as well.
struct GuidedQuery {
  const std::vector<std::vector<std::uint64_t>>& distances;  // by height
  std::uint32_t start;
  std::uint32_t goal;

  static HierarchyCost part_of(std::uint64_t distance) {
    return static_cast<HierarchyCost>(distance * 2 / 3);
  }
  HierarchyCost to_start(std::uint32_t node) const { return part_of(distances[start][node]); }
  HierarchyCost to_goal(std::uint32_t node) const { return part_of(distances[node][goal]); }
  template <class Visit>
  void for_each_start(std::uint32_t /*i*/, Visit&& visit) const {
    visit(start);
  }
  template <class Visit>
  void for_each_goal(std::uint32_t /*i*/, Visit&& visit) const {
    visit(goal);
  }
};

/// More bits if arcs are expensive, so that a search has few buckets.
unsigned unordered_bits(const RandomGraph& graph, std::uint64_t seed) {
  constexpr HierarchyCost kCheap = 100;
  const bool dear = std::any_of(graph.arcs.begin(), graph.arcs.end(),
                                [](const GraphArc& arc) { return arc.cost > kCheap; });
  return dear ? 15 : static_cast<unsigned>(seed % 3);
}

/// The distances with nodes numbered by height.
std::vector<std::vector<std::uint64_t>> by_height(const RandomGraph& graph,
                                                  const std::vector<std::uint32_t>& heights) {
  const auto distances = graph.distances();
  auto result = distances;
  for (std::uint32_t tail = 0; tail < graph.nodes; ++tail) {
    for (std::uint32_t head = 0; head < graph.nodes; ++head) {
      result[heights[tail]][heights[head]] = distances[tail][head];
    }
  }
  return result;
}

std::vector<std::uint32_t> path_of(HierarchySearch& search,
                                   const std::vector<std::uint32_t>& heights) {
  std::vector<std::uint32_t> path;
  search.append_nodes(path);
  for (std::uint32_t& node : path) {
    node = static_cast<std::uint32_t>(std::find(heights.begin(), heights.end(), node) -
                                      heights.begin());
  }
  return path;
}

TEST(GraphContraction, KeepsEveryShortestPath) {
  for (const ContractionEffort& effort : kEfforts) {
    for (std::uint64_t seed = 1; seed <= test::share_of(kGraphs); ++seed) {
      SCOPED_TRACE(seed);
      const RandomGraph graph(seed);
      const ContractedGraph result = contracted(graph, effort);
      const auto distances = graph.distances();
      const auto& heights = result.heights;
      HierarchySearch search(result.hierarchy(), unordered_bits(graph, seed));
      auto guiding = by_height(graph, heights);
      for (auto& row : guiding) std::replace(row.begin(), row.end(), kNoWay, graph.total_cost());
      for (std::uint32_t start = 0; start < graph.nodes; ++start) {
        for (std::uint32_t goal = 0; goal < graph.nodes; ++goal) {
          constexpr HierarchyEnd kEnd{0, 0};
          constexpr HierarchyCost kNoBound = HierarchySearch::kNoCost;
          const auto distance = static_cast<HierarchyCost>(distances[start][goal]);
          const PlainQuery plain{{heights[start]}, {heights[goal]}};
          const GuidedQuery guided{guiding, heights[start], heights[goal]};
          ASSERT_EQ(search.find({&kEnd, 1}, {&kEnd, 1}, kNoBound, plain), distance);
          ASSERT_EQ(search.find({&kEnd, 1}, {&kEnd, 1}, kNoBound, guided), distance);
          if (distance == kNoWay) continue;
          const auto path = path_of(search, heights);
          ASSERT_EQ(path.front(), start);
          ASSERT_EQ(path.back(), goal);
          ASSERT_EQ(graph.cost_of(path), distance);
          ASSERT_EQ(search.find({&kEnd, 1}, {&kEnd, 1}, distance, guided), distance) << "the bound";
        }
      }
    }
  }
}

TEST(GraphContraction, FindsTheBestOfManyStartsAndGoals) {
  for (std::uint64_t seed = 1; seed <= kGraphs; ++seed) {
    SCOPED_TRACE(seed);
    const RandomGraph graph(seed);
    const ContractedGraph result = contracted(graph, seed % 2 == 0 ? kInPart : kSmall);
    const auto distances = by_height(graph, result.heights);
    HierarchySearch search(result.hierarchy(), unordered_bits(graph, seed));
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const auto some_ends = [&](std::vector<std::uint32_t>& nodes) {
        std::vector<HierarchyEnd> ends(random.below(4));
        for (HierarchyEnd& end : ends) {
          nodes.push_back(static_cast<std::uint32_t>(random.below(graph.nodes)));
          end.cost = end.key = static_cast<HierarchyCost>(random.below(6));
        }
        return ends;
      };
      PlainQuery query;
      const auto starts = some_ends(query.starts);
      const auto goals = some_ends(query.goals);
      std::uint64_t least = kNoWay;
      for (std::size_t a = 0; a < starts.size(); ++a) {
        for (std::size_t b = 0; b < goals.size(); ++b) {
          least = std::min(
              least, starts[a].cost + goals[b].cost + distances[query.starts[a]][query.goals[b]]);
        }
      }
      ASSERT_EQ(search.find(starts, goals, HierarchySearch::kNoCost, query), least);
      ASSERT_GE(search.metrics().generated, search.metrics().expanded);
    }
  }
}

TEST(GraphContraction, LeavesACoreWhenItsWorkIsDone) {
  std::uint32_t in_part = 0;
  for (std::uint64_t seed = 1; seed <= kGraphs; ++seed) {
    const RandomGraph graph(seed);
    EXPECT_EQ(contracted(graph, {}).core_begin, graph.nodes) << "all are taken out";
    EXPECT_EQ(contracted(graph, kNothing).core_begin, 0U) << "none is";
    const std::uint32_t core_begin = contracted(graph, kInPart).core_begin;
    in_part += core_begin > 0 && core_begin < graph.nodes ? 1 : 0;
  }
  EXPECT_GT(in_part, kGraphs / 10);
}

TEST(GraphContraction, IsTheSameEveryTime) {
  const RandomGraph graph(7);
  const ContractedGraph a = contracted(graph, {});
  const ContractedGraph b = contracted(graph, {});
  EXPECT_EQ(a.heights, b.heights);
  EXPECT_EQ(a.arcs, b.arcs);
  EXPECT_EQ(a.vias, b.vias);
}

TEST(GraphContraction, StopsWhenItIsCancelled) {
  const std::atomic<bool> cancel = true;
  IndexBuilding building;
  building.cancel = &cancel;
  const auto result = contract(3, {}, {}, building);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().status, Status::cancelled);
}

TEST(GraphContraction, TellsHowFarItIs) {
  std::vector<double> shares;
  IndexBuilding building;
  building.progress = [&](double share) { shares.push_back(share); };
  ASSERT_TRUE(contract(2000, {}, {}, building));
  EXPECT_GT(shares.size(), 3U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LE(shares.back(), 1);
}

/// Changes random numbers: a hierarchy that still passes the check can be searched, and the search ends.
TEST(ContractionHierarchy, OfRandomNumbersIsRefusedOrHarmless) {
  int refused = 0;
  constexpr int kTries = 4000;
  for (std::uint64_t seed = 1; seed <= kTries; ++seed) {
    SCOPED_TRACE(seed);
    const RandomGraph graph(seed % kGraphs + 1);
    ContractedGraph result = contracted(graph, kEfforts[seed % 4]);
    ASSERT_EQ(fault_of(result.hierarchy()), std::nullopt);
    Random random(seed);
    const auto damage = [&](auto& numbers) {
      if (numbers.empty() || random.chance(0.5)) return;
      auto& victim = numbers[random.below(numbers.size())];
      auto* const words = reinterpret_cast<std::uint32_t*>(&victim);
      words[random.below(sizeof victim / 4)] = static_cast<std::uint32_t>(
          random.chance(0.7) ? random.below(2 * graph.nodes) : random.bits());
    };
    damage(result.nodes);
    damage(result.arcs);
    damage(result.vias);
    if (random.chance(0.2)) result.core_begin = static_cast<std::uint32_t>(random.below(30));
    if (fault_of(result.hierarchy())) {
      ++refused;
      continue;
    }
    HierarchySearch search(result.hierarchy(), 15);
    for (std::uint32_t start = 0; start < graph.nodes; ++start) {
      constexpr HierarchyEnd kEnd{0, 0};
      constexpr HierarchyCost kBound = HierarchySearch::kNoCost;
      const PlainQuery query{{start}, {static_cast<std::uint32_t>(random.below(graph.nodes))}};
      std::vector<std::uint32_t> nodes;
      if (search.find({&kEnd, 1}, {&kEnd, 1}, kBound, query) < kBound) {
        search.append_nodes(nodes);
      }
      for (const std::uint32_t node : nodes) ASSERT_LT(node, graph.nodes);
    }
  }
  EXPECT_GT(refused, kTries / 4);
}

}  // namespace
}  // namespace wend
