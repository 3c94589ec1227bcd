#include "wend/map/connected_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>

#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

constexpr Adjacency kAdjacencies[] = {Adjacency::edges, Adjacency::edges_and_corners};

/// Regions by flooding from one cell after the other: 0 where nothing is set, else 1, 2, ...
Grid<int> flooded(const BitGrid& bits, Adjacency adjacency) {
  Grid<int> regions(bits.width(), bits.height(), 0);
  int count = 0;
  for (const Cell seed : test::all_cells(bits.width(), bits.height())) {
    if (!bits[seed] || regions[seed] != 0) continue;
    std::vector<Cell> reached{seed};
    regions[seed] = ++count;
    while (!reached.empty()) {
      const Cell here = reached.back();
      reached.pop_back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (adjacency == Adjacency::edges && dx != 0 && dy != 0) continue;
          const Cell next{here.x + dx, here.y + dy};
          if (!bits.contains(next) || !bits[next] || regions[next] != 0) continue;
          regions[next] = count;
          reached.push_back(next);
        }
      }
    }
  }
  return regions;
}

void expect_same_regions(const BitGrid& bits, Adjacency adjacency) {
  const ConnectedRegions found(bits);
  const Grid<int> expected = flooded(bits, adjacency);
  std::map<int, std::size_t> sizes;
  for (const int region : expected.values()) {
    if (region != 0) ++sizes[region];
  }

  std::map<int, std::uint32_t> found_of;  // one to one
  std::map<std::uint32_t, int> expected_of;
  for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
    SCOPED_TRACE(testing::Message() << "cell " << cell.x << "," << cell.y);
    const std::uint32_t region = found.region(cell, adjacency);
    ASSERT_EQ(region != 0, bits[cell]);
    ASSERT_EQ(found_of.emplace(expected[cell], region).first->second, region);
    ASSERT_EQ(expected_of.emplace(region, expected[cell]).first->second, expected[cell]);
    ASSERT_EQ(found.size_of_region(cell, adjacency), bits[cell] ? sizes[expected[cell]] : 0);
  }

  EXPECT_EQ(found.count(adjacency), sizes.size());
  std::vector<std::size_t> largest_first;
  for (const auto& [region, size] : sizes) largest_first.push_back(size);
  std::sort(largest_first.begin(), largest_first.end(), std::greater<>());
  EXPECT_EQ(found.sizes(adjacency), largest_first);
}

TEST(ConnectedRegions, AreWhatFloodingFinds) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_odd_bits(random);
    for (const Adjacency adjacency : kAdjacencies) expect_same_regions(bits, adjacency);
    if (HasFatalFailure()) return;
  }
}

TEST(ConnectedRegions, ConnectCellsOfOneRegionOnly) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_bits(random, 9, 7, 0.6);
    const ConnectedRegions regions(bits);
    for (const Adjacency adjacency : kAdjacencies) {
      const Grid<int> expected = flooded(bits, adjacency);
      for (const Cell a : test::all_cells(9, 7)) {
        for (const Cell b : test::all_cells(9, 7)) {
          ASSERT_EQ(regions.connected(a, b, adjacency),
                    expected[a] != 0 && expected[a] == expected[b]);
        }
      }
    }
  }
}

TEST(ConnectedRegions, JoinCornersOnlyWhereAsked) {
  BitGrid bits(4, 2);
  bits.set({0, 0}, true);
  bits.set({1, 1}, true);
  bits.set({3, 0}, true);
  const ConnectedRegions regions(bits);
  EXPECT_FALSE(regions.connected({0, 0}, {1, 1}, Adjacency::edges));
  EXPECT_TRUE(regions.connected({0, 0}, {1, 1}, Adjacency::edges_and_corners));
  EXPECT_FALSE(regions.connected({0, 0}, {3, 0}, Adjacency::edges_and_corners));
  EXPECT_EQ(regions.sizes(Adjacency::edges), (std::vector<std::size_t>{1, 1, 1}));
  EXPECT_EQ(regions.sizes(Adjacency::edges_and_corners), (std::vector<std::size_t>{2, 1}));
}

TEST(ConnectedRegions, AreNoneWhereNothingIsSet) {
  for (const Adjacency adjacency : kAdjacencies) {
    const ConnectedRegions regions(BitGrid(70, 3));
    EXPECT_EQ(regions.count(adjacency), 0U);
    EXPECT_TRUE(regions.sizes(adjacency).empty());
    EXPECT_FALSE(regions.connected({1, 1}, {1, 1}, adjacency));
  }
}

}  // namespace
}  // namespace wend
