#include "wend/map/connected_components.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>

#include "tests/testing/share.hpp"
#include "wend/map/grid.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

constexpr Adjacency kAdjacencies[] = {Adjacency::edges, Adjacency::edges_and_corners};

/// Components by flood fill from each cell in turn: 0 where nothing is set, else 1, 2, ...
Grid<int> flooded(const BitGrid& bits, Adjacency adjacency) {
  Grid<int> components(bits.width(), bits.height(), 0);
  int count = 0;
  for (const Cell seed : test::all_cells(bits.width(), bits.height())) {
    if (!bits[seed] || components[seed] != 0) continue;
    std::vector<Cell> reached{seed};
    components[seed] = ++count;
    while (!reached.empty()) {
      const Cell here = reached.back();
      reached.pop_back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (adjacency == Adjacency::edges && dx != 0 && dy != 0) continue;
          const Cell next{here.x + dx, here.y + dy};
          if (!bits.contains(next) || !bits[next] || components[next] != 0) continue;
          components[next] = count;
          reached.push_back(next);
        }
      }
    }
  }
  return components;
}

void expect_same_components(const BitGrid& bits, Adjacency adjacency) {
  const ConnectedComponents found(bits);
  const Grid<int> expected = flooded(bits, adjacency);
  std::map<int, std::size_t> sizes;
  for (const int component : expected.values()) {
    if (component != 0) ++sizes[component];
  }

  std::map<int, std::uint32_t> found_of;  // one to one
  std::map<std::uint32_t, int> expected_of;
  for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
    SCOPED_TRACE(testing::Message() << "cell " << cell.x << "," << cell.y);
    const std::uint32_t component = found.component(cell, adjacency);
    ASSERT_EQ(component != 0, bits[cell]);
    ASSERT_EQ(found_of.emplace(expected[cell], component).first->second, component);
    ASSERT_EQ(expected_of.emplace(component, expected[cell]).first->second, expected[cell]);
    ASSERT_EQ(found.size_of_component(cell, adjacency), bits[cell] ? sizes[expected[cell]] : 0);
  }

  EXPECT_EQ(found.count(adjacency), sizes.size());
  std::vector<std::size_t> largest_first;
  for (const auto& [component, size] : sizes) largest_first.push_back(size);
  std::sort(largest_first.begin(), largest_first.end(), std::greater<>());
  EXPECT_EQ(found.sizes(adjacency), largest_first);
}

TEST(ConnectedComponents, AreWhatFloodingFinds) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_odd_bits(random);
    for (const Adjacency adjacency : kAdjacencies) expect_same_components(bits, adjacency);
    if (HasFatalFailure()) return;
  }
}

TEST(ConnectedComponents, ConnectCellsOfOneRegionOnly) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_bits(random, 9, 7, 0.6);
    const ConnectedComponents components(bits);
    for (const Adjacency adjacency : kAdjacencies) {
      const Grid<int> expected = flooded(bits, adjacency);
      for (const Cell a : test::all_cells(9, 7)) {
        for (const Cell b : test::all_cells(9, 7)) {
          ASSERT_EQ(components.connected(a, b, adjacency),
                    expected[a] != 0 && expected[a] == expected[b]);
        }
      }
    }
  }
}

TEST(ConnectedComponents, AreRepairedToWhatTheyWouldBe) {
  for (std::uint64_t seed = 0; seed < test::share_of(150U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const int width = random.between(1, 200);
    const int height = random.between(1, 150);
    const double density = random.uniform();
    BitGrid bits = test::random_bits(random, width, height, density);
    ConnectedComponents repaired(bits);
    for (int edit = 0; edit < 4; ++edit) {
      const Cell from{random.between(0, width - 1), random.between(0, height - 1)};
      const Cell to{random.between(from.x + 1, width), random.between(from.y + 1, height)};
      const CellBox box{from, to};
      const double share = random.uniform();
      for (int y = box.begin.y; y < box.end.y; ++y) {
        for (int x = box.begin.x; x < box.end.x; ++x) bits.set({x, y}, random.chance(share));
      }
      repaired.repair(bits, box);
      if (random.chance(0.3)) continue;  // nobody asks between two edits
      const ConnectedComponents fresh(bits);
      for (const Adjacency adjacency : kAdjacencies) {
        ASSERT_EQ(repaired.sizes(adjacency), fresh.sizes(adjacency));
        for (const Cell cell : test::all_cells(width, height)) {
          ASSERT_EQ(repaired.component(cell, adjacency), fresh.component(cell, adjacency));
          ASSERT_EQ(repaired.size_of_component(cell, adjacency),
                    fresh.size_of_component(cell, adjacency));
        }
      }
    }
  }
}

TEST(ConnectedComponents, AreThoseOfWholeMapsOverManyTiles) {
  for (std::uint64_t seed = 0; seed < test::share_of(12U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const int width = random.between(120, 200);
    const int height = random.between(120, 200);
    const BitGrid bits = test::random_bits(random, width, height, random.chance(0.5) ? 0.5 : 0.6);
    for (const Adjacency adjacency : kAdjacencies) expect_same_components(bits, adjacency);
    if (HasFatalFailure()) return;
  }
}

TEST(ConnectedComponents, JoinCornersOnlyWhereAsked) {
  BitGrid bits(4, 2);
  bits.set({0, 0}, true);
  bits.set({1, 1}, true);
  bits.set({3, 0}, true);
  const ConnectedComponents components(bits);
  EXPECT_FALSE(components.connected({0, 0}, {1, 1}, Adjacency::edges));
  EXPECT_TRUE(components.connected({0, 0}, {1, 1}, Adjacency::edges_and_corners));
  EXPECT_FALSE(components.connected({0, 0}, {3, 0}, Adjacency::edges_and_corners));
  EXPECT_EQ(components.sizes(Adjacency::edges), (std::vector<std::size_t>{1, 1, 1}));
  EXPECT_EQ(components.sizes(Adjacency::edges_and_corners), (std::vector<std::size_t>{2, 1}));
}

TEST(ConnectedComponents, AreNoneWhereNothingIsSet) {
  for (const Adjacency adjacency : kAdjacencies) {
    const ConnectedComponents components(BitGrid(70, 3));
    EXPECT_EQ(components.count(adjacency), 0U);
    EXPECT_TRUE(components.sizes(adjacency).empty());
    EXPECT_FALSE(components.connected({1, 1}, {1, 1}, adjacency));
  }
}

}  // namespace
}  // namespace wend
