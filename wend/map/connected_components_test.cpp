#include "wend/map/connected_components.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>

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

ComponentCounter counted(const BitGrid& cells) {
  ComponentCounter counter(cells.width());
  for (int y = 0; y < cells.height(); ++y) counter.add_row(cells.row_words(y));
  return counter;
}

BitGrid drawn(const std::vector<std::string>& rows) {
  BitGrid cells(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const auto letter = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      cells.set({x, y}, letter == '.');
    }
  }
  return cells;
}

TEST(ComponentCounter, JoinsRegionsThatMeetLater) {
  const ComponentCounter counter = counted(drawn({".#.#.", ".#.##", "...#.", "##.#."}));
  EXPECT_EQ(counter.count(), 3U);
  EXPECT_EQ(counter.largest(), 8U);
}

TEST(ComponentCounter, KnowsNoRegionsWhereThereIsNoCell) {
  EXPECT_EQ(counted(BitGrid(5, 3)).count(), 0U);
  EXPECT_EQ(counted(BitGrid(5, 3)).largest(), 0U);
}

RC_GTEST_PROP(ComponentCounter, CountsWhatConnectedComponentsLabels, ()) {
  BitGrid cells(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 30));
  const int share = *rc::gen::inRange(1, 10);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) cells.set({x, y}, *rc::gen::inRange(0, 10) < share);
  }
  const auto sizes = ConnectedComponents(cells).sizes(Adjacency::edges);
  const ComponentCounter counter = counted(cells);
  RC_ASSERT(counter.count() == sizes.size());
  RC_ASSERT(counter.largest() == (sizes.empty() ? 0 : sizes.front()));
}

}  // namespace
}  // namespace wend
