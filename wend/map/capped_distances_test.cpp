#include "wend/map/capped_distances.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/testing/share.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

/// By the definition, over all blocked squares and, if it counts, the edge.
std::uint32_t nearest(const std::vector<Cell>& blocked, const BitGrid& map, bool edge_counts,
                      Cell from, std::uint32_t far) {
  std::uint32_t least = far;
  for (const Cell square : blocked) {
    const int dx = std::max(0, 2 * std::abs(square.x - from.x) - 1);
    const int dy = std::max(0, 2 * std::abs(square.y - from.y) - 1);
    least = std::min(least, static_cast<std::uint32_t>(dx * dx + dy * dy));
  }
  if (!edge_counts) return least;
  const int to_edge =
      2 * std::min({from.x, map.width() - 1 - from.x, from.y, map.height() - 1 - from.y}) + 1;
  return std::min(least, static_cast<std::uint32_t>(to_edge * to_edge));
}

std::vector<Cell> set_cells(const BitGrid& bits) {
  std::vector<Cell> cells = test::all_cells(bits.width(), bits.height());
  std::erase_if(cells, [&](Cell cell) { return !bits[cell]; });
  return cells;
}

int random_cap(Random& random) {
  return random.chance(0.2) ? CappedDistances::kLargestCap : random.between(1, 12);
}

TEST(CappedDistances, AreExactUpToTheCap) {
  for (std::uint64_t seed = 0; seed < test::share_of(400U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_odd_bits(random);
    const bool edge_counts = random.chance(0.5);
    const int cap = random_cap(random);
    const CappedDistances distances(bits, edge_counts, cap);
    ASSERT_EQ(distances.far(), static_cast<std::uint32_t>((2 * cap + 1) * (2 * cap + 1)));
    const std::vector<Cell> blocked = set_cells(bits);
    for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
      ASSERT_EQ(distances[cell], nearest(blocked, bits, edge_counts, cell, distances.far()))
          << "at " << cell.x << "," << cell.y << " of " << bits.width() << " x " << bits.height()
          << ", cap " << cap << (edge_counts ? ", the edge counts" : "");
    }
  }
}

TEST(CappedDistances, AreExactWhereAMapIsComputedInBands) {
  Random random(7);
  BitGrid bits(9, 300'000);
  for (int i = 0; i < 20'000; ++i) {
    const Cell cell{random.between(0, 8), random.between(0, bits.height() - 1)};
    bits.set(cell, true);
  }
  const CappedDistances distances(bits, false, 5);
  constexpr int kRows = 140'000;
  for (int y = 110'000; y < 110'000 + kRows; y += kRows / test::share_of(kRows)) {
    std::vector<Cell> near;
    for (int row = y - 6; row <= y + 6; ++row) {
      for (int x = 0; x < 9; ++x) {
        if (bits[{x, row}]) near.push_back({x, row});
      }
    }
    for (const int x : {0, 4, 8}) {
      ASSERT_EQ((distances[{x, y}]), nearest(near, bits, false, {x, y}, distances.far())) << y;
    }
  }
}

TEST(CappedDistances, AreRepairedToWhatTheyWouldBe) {
  for (std::uint64_t seed = 0; seed < test::share_of(400U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    BitGrid bits = test::random_odd_bits(random);
    const bool edge_counts = random.chance(0.5);
    const int cap = random_cap(random);
    CappedDistances distances(bits, edge_counts, cap);
    for (int edit = 0; edit < 8; ++edit) {
      const int left = random.between(0, bits.width() - 1);
      const int low = random.between(0, bits.height() - 1);
      const CellBox box = CellBox{{left, low},
                                  {left + 1 + static_cast<int>(random.below(9)),
                                   low + 1 + static_cast<int>(random.below(9))}}
                              .clipped_to(bits);
      const double density = random.uniform();
      for (int y = box.begin.y; y < box.end.y; ++y) {
        for (int x = box.begin.x; x < box.end.x; ++x) bits.set({x, y}, random.chance(density));
      }
      const CappedDistances before = distances;
      const CellBox changed = distances.repair(bits, box);
      ASSERT_TRUE(distances == CappedDistances(bits, edge_counts, cap));
      CellBox expected;
      for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
        if (before[cell] == distances[cell]) continue;
        expected = expected.joined_with({cell, {cell.x + 1, cell.y + 1}});
      }
      ASSERT_EQ(changed, expected);
    }
  }
}

TEST(CappedDistances, SelectTheCellsThatAreFarEnough) {
  for (std::uint64_t seed = 0; seed < test::share_of(200U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_odd_bits(random);
    const CappedDistances distances(bits, random.chance(0.5), random_cap(random));
    const int left = random.between(0, bits.width() - 1);
    const int low = random.between(0, bits.height() - 1);
    const int right = random.between(left + 1, bits.width());
    const int high = random.between(low + 1, bits.height());
    const CellBox box{{left, low}, {right, high}};
    const auto least =
        static_cast<std::uint32_t>(random.between(1, static_cast<int>(distances.far())));
    const BitGrid before = test::random_bits(random, bits.width(), bits.height(), 0.5);
    BitGrid cells = before;
    distances.select(least, box, cells);
    for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
      ASSERT_EQ(cells[cell], box.contains(cell) ? distances[cell] >= least : before[cell])
          << cell.x << "," << cell.y;
    }
    for (int y = 0; y < cells.height(); ++y) {  // the border stays free
      ASSERT_FALSE((cells[{-1, y}]));
      ASSERT_FALSE((cells[{cells.width(), y}]));
    }
  }
}

}  // namespace
}  // namespace wend
