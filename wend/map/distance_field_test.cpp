#include "wend/map/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

/// By the definition: the minimum over all blocked squares, in whole half-cells.
std::uint32_t nearest_square(const std::vector<Cell>& blocked, Cell from) {
  std::uint32_t least = kNoObstacle;
  for (const Cell square : blocked) {
    const int dx = std::max(0, 2 * std::abs(square.x - from.x) - 1);
    const int dy = std::max(0, 2 * std::abs(square.y - from.y) - 1);
    least = std::min(least, static_cast<std::uint32_t>(dx * dx + dy * dy));
  }
  return least;
}

void expect_exact(const BitGrid& bits) {
  std::vector<Cell> blocked = test::all_cells(bits.width(), bits.height());
  std::erase_if(blocked, [&](Cell cell) { return !bits[cell]; });
  const Grid<std::uint32_t> field = squared_half_cell_distances(bits);
  ASSERT_EQ(field.width(), bits.width());
  ASSERT_EQ(field.height(), bits.height());
  for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
    const std::uint32_t expected = nearest_square(blocked, cell);
    ASSERT_EQ(field[cell], expected)
        << "at " << cell.x << "," << cell.y << " of " << bits.width() << " x " << bits.height();
    std::size_t words = 0;
    ASSERT_EQ(squared_half_cell_distance(bits, cell, kNoObstacle, words), expected)
        << "at " << cell.x << "," << cell.y << " of " << bits.width() << " x " << bits.height();
    for (const std::uint32_t most : {0U, 1U, 30U, 5000U}) {
      ASSERT_EQ(squared_half_cell_distance(bits, cell, most, words), std::min(expected, most));
    }
  }
}

TEST(DistanceField, IsExactOnMapsOfEveryShape) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    expect_exact(test::random_odd_bits(random));
    if (HasFatalFailure()) return;
  }
}

TEST(DistanceField, IsExactAroundFewObstacles) {
  // Far from obstacles, where the borders between nearest-obstacle regions are long and slanted.
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    BitGrid bits(random.between(1, 150), random.between(1, 90));
    for (int count = random.between(1, 6); count > 0; --count) {
      bits.set({random.between(0, bits.width() - 1), random.between(0, bits.height() - 1)}, true);
    }
    expect_exact(bits);
    if (HasFatalFailure()) return;
  }
}

TEST(DistanceField, IsExactForAllPairsOfObstaclesInARow) {
  constexpr int kWidth = 12;
  for (int height = 1; height <= 9; height += 4) {
    for (int a = 0; a < kWidth; ++a) {
      for (int b = 0; b < kWidth; ++b) {
        for (int row = 0; row < height; ++row) {
          BitGrid bits(kWidth, height);
          bits.set({a, 0}, true);
          bits.set({b, row}, true);
          expect_exact(bits);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST(DistanceField, CountsHalfCellsToTheEdgesOfSquares) {
  BitGrid bits(4, 3);
  bits.set({0, 0}, true);
  const auto field = squared_half_cell_distances(bits);
  EXPECT_EQ((field[{0, 0}]), 0U);
  EXPECT_EQ((field[{1, 0}]), 1U);   // half a cell
  EXPECT_EQ((field[{3, 0}]), 25U);  // two and a half cells
  EXPECT_EQ((field[{1, 1}]), 2U);   // to a corner
  EXPECT_EQ((field[{2, 1}]), 10U);
}

TEST(DistanceField, WithoutObstaclesHoldsNone) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {70, 3}}) {
    const auto field = squared_half_cell_distances(BitGrid(width, height));
    for (const std::uint32_t squared : field.values()) EXPECT_EQ(squared, kNoObstacle);
  }
}

TEST(DistanceField, EndsBeyond32768Cells) {
  constexpr int kLength = 40000;
  for (const bool upright : {false, true}) {
    SCOPED_TRACE(upright ? "column" : "row");
    BitGrid bits(upright ? 1 : kLength, upright ? kLength : 1);
    bits.set({0, 0}, true);
    const auto field = squared_half_cell_distances(bits);
    const auto at = [&](int cells) { return field[upright ? Cell{0, cells} : Cell{cells, 0}]; };
    for (const int cells : {1, 1000, 30000, 32767}) {
      const auto half_cells = static_cast<std::uint32_t>(2 * cells - 1);
      EXPECT_EQ(at(cells), half_cells * half_cells) << cells;
    }
    for (const int cells : {32769, 33000, kLength - 1}) {
      EXPECT_EQ(at(cells), kNoObstacle) << cells;
      std::size_t words = 0;
      const Cell from = upright ? Cell{0, cells} : Cell{cells, 0};
      EXPECT_EQ(squared_half_cell_distance(bits, from, kNoObstacle, words), kNoObstacle) << cells;
    }
  }
}

}  // namespace
}  // namespace wend
