#include "wend/index/hub_labels/hub_labelling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "wend/index/brute_distances_test.hpp"
#include "wend/index/hub_labels/hub_sections.hpp"
#include "wend/index/hub_labels/label_order.hpp"

namespace wend {
namespace {

using test::brute_distances;
using test::for_small_boards;
using test::kUnreached;
using test::text_of;

/// The labelling of a board, with the graph and first corners that it needs.
struct Labelled {
  explicit Labelled(const BitGrid& bits)
      : graph(Corners(bits)), first(graph.corners()), labelling(graph, building) {
    LabelOrder order(graph, first, labelling, building);
    for (std::size_t i = 0; i < graph.size(); ++i) labelling.add_hub(order.next());
  }

  IndexBuilding building;
  CornerGraph graph;
  AllFirstCorners first;
  HubLabelling labelling;
};

TEST(LabelOrder, TakesEveryCornerOnce) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Labelled map(bits);
    std::set<std::uint32_t> hubs;
    for (std::uint32_t i = 0; i < map.labelling.hubs(); ++i) {
      hubs.insert(map.labelling.corner_of(i));
    }
    ASSERT_EQ(hubs.size(), map.graph.size());
  });
}

TEST(LabelOrder, TakesTheOnlyWayThroughFirst) {
  BitGrid bits(41, 11);
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 41; ++x) bits.set({x, y}, x != 20 || y == 5);
  }
  const Labelled map(bits);  // a gap of one cell in a wall
  EXPECT_EQ(std::abs(map.graph.corners().cell(map.labelling.corner_of(0)).x - 20), 1);
}

/// The least sum over the hubs of both labels.
std::uint64_t cost_by_hubs(std::span<const HubEntry> from, std::span<const HubEntry> to) {
  std::uint64_t least = kUnreached;
  for (const HubEntry& a : from) {
    for (const HubEntry& b : to) {
      if (a.hub == b.hub) least = std::min(least, std::uint64_t{a.cost} + b.cost);
    }
  }
  return least;
}

TEST(HubLabelling, GivesTheDistanceOfAnyTwoCorners) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Labelled map(bits);
    const Corners& corners = map.graph.corners();
    for (std::uint32_t from = 0; from < corners.size(); ++from) {
      const auto expected = brute_distances(bits, corners.cell(from));
      for (std::uint32_t to = 0; to < corners.size(); ++to) {
        ASSERT_EQ(cost_by_hubs(map.labelling.label(from), map.labelling.label(to)),
                  expected[corners.cell(to)]);
      }
    }
  });
}

TEST(HubLabelling, KeepsTheTreeOfEveryHubInTheOrderOfCosts) {
  for_small_boards(100, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Labelled map(bits);
    for (std::uint32_t hub = 0; hub < map.labelling.hubs(); ++hub) {
      const auto tree = map.labelling.tree(hub);
      ASSERT_EQ(tree.front().corner, map.labelling.corner_of(hub));
      ASSERT_EQ(tree.front().parent, HubTreeNode::kRoot);
      const auto distances = brute_distances(bits, map.graph.corners().cell(tree.front().corner));
      const auto distance = [&](const HubTreeNode& node) {
        return distances[map.graph.corners().cell(node.corner)];
      };
      for (std::size_t i = 1; i < tree.size(); ++i) {
        ASSERT_LT(tree[i].parent, i);
        ASSERT_GE(distance(tree[i]), distance(tree[i - 1]));
        ASSERT_EQ(distance(tree[i]) - distance(tree[tree[i].parent]),
                  octile_cost<CornerCost>(map.graph.corners().cell(tree[i].corner),
                                          map.graph.corners().cell(tree[tree[i].parent].corner)));
      }
    }
  });
}

/// The end and the cost of the runs from a place, followed from a cell.
struct Walk {
  Cell end;
  std::uint64_t cost = 0;
};

Walk walked(std::span<const RunWord> words, std::uint32_t place, Cell from) {
  Walk walk{from};
  while (place != run_word::kHub) {
    for (; words[place] != run_word::kJoint; ++place) {
      const auto steps = run_word::steps(words[place]);
      const Direction direction = run_word::direction(words[place]);
      for (unsigned i = 0; i < steps; ++i) walk.end = step(walk.end, direction);
      walk.cost += std::uint64_t{steps} * (is_diagonal(direction) ? 47321 : 33461);
    }
    place = words[place + 1] | static_cast<std::uint32_t>(words[place + 2]) << 16U;
  }
  return walk;
}

TEST(HeavyPaths, LeadFromEveryCornerToItsHubs) {
  for_small_boards(300, [](const BitGrid& bits) {
    SCOPED_TRACE(text_of(bits));
    const Labelled map(bits);
    const Corners& corners = map.graph.corners();
    const HeavyPaths paths(corners, map.labelling);
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
      const auto label = map.labelling.label(corner);
      ASSERT_EQ(paths.places(corner).size(), label.size());
      for (std::size_t i = 0; i < label.size(); ++i) {
        const Walk walk = walked(paths.words(), paths.places(corner)[i], corners.cell(corner));
        ASSERT_EQ(walk.end, corners.cell(map.labelling.corner_of(label[i].hub)));
        ASSERT_EQ(walk.cost, label[i].cost);
      }
    }
  });
}

}  // namespace
}  // namespace wend
