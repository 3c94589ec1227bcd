#include "wend/map/bit_grid.hpp"

#include <gtest/gtest.h>

#include <set>

#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

/// Widths near those at which the border makes a row one word longer.
const std::vector<int> kWidths{1, 2, 61, 62, 63, 64, 65, 66, 125, 126, 127, 128, 129, 130};

class BitGridOfWidth : public testing::TestWithParam<int> {};

TEST_P(BitGridOfWidth, KeepsWhatIsSet) {
  const int width = GetParam();
  const int height = 5;
  Random random(static_cast<std::uint64_t>(width));
  BitGrid bits(width, height);
  std::set<Cell> expected;
  for (int i = 0; i < 4 * width * height; ++i) {
    const Cell cell{random.between(0, width - 1), random.between(0, height - 1)};
    const bool value = random.chance(0.5);
    bits.set(cell, value);
    value ? static_cast<void>(expected.insert(cell)) : static_cast<void>(expected.erase(cell));
  }
  for (const Cell cell : test::all_cells(width, height)) {
    ASSERT_EQ(bits[cell], expected.contains(cell)) << cell.x << "," << cell.y;
  }
  EXPECT_EQ(bits.count(), expected.size());
}

TEST_P(BitGridOfWidth, HasABorderOfZeros) {
  const int width = GetParam();
  Random random(1);
  for (const int height : {1, 3}) {
    const BitGrid full = test::random_bits(random, width, height, 1);
    EXPECT_EQ(full.count(), static_cast<std::size_t>(width * height));
    for (int y = -1; y <= height; ++y) {
      for (int x = -1; x <= width; ++x) {
        ASSERT_EQ((full[{x, y}]), full.contains({x, y})) << x << "," << y;
      }
    }
  }
}

TEST_P(BitGridOfWidth, ReadsTheBlockAroundACellAtOnce) {
  const int width = GetParam();
  const int height = 4;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_bits(random, width, height, random.uniform());
    for (const Cell cell : test::all_cells(width, height)) {
      unsigned expected = 0;
      unsigned bit = 1;
      for (const int dy : {1, 0, -1}) {
        for (const int dx : {-1, 0, 1}) {
          if (bits[{cell.x + dx, cell.y + dy}]) expected |= bit;
          bit *= 2;
        }
      }
      ASSERT_EQ(bits.block(cell), expected) << cell.x << "," << cell.y;
    }
  }
}

TEST_P(BitGridOfWidth, ShowsCellsAsBitsOfWords) {
  const int width = GetParam();
  Random random(2);
  BitGrid bits = test::random_bits(random, width, 3, 0.5);
  for (int y = -1; y <= 3; ++y) {
    const auto words = static_cast<const BitGrid&>(bits).row_words(y);
    for (std::size_t bit = 0; bit < 64 * words.size(); ++bit) {
      const int x = static_cast<int>(bit) - 1;
      const bool expected = bits.contains({x, y}) && bits[{x, y}];
      ASSERT_EQ((words[bit / 64] >> (bit % 64)) & 1U, expected ? 1U : 0U) << x << "," << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, BitGridOfWidth, testing::ValuesIn(kWidths));

TEST(BitGrid, IsEqualInShapeAndBits) {
  BitGrid a(3, 2);
  BitGrid b(3, 2);
  EXPECT_EQ(a, b);
  a.set({2, 1}, true);
  EXPECT_NE(a, b);
  b.set({2, 1}, true);
  EXPECT_EQ(a, b);
  EXPECT_NE(BitGrid(3, 2), BitGrid(2, 3));
}

TEST(BitGrid, WithoutCellsContainsNothing) {
  const BitGrid none;
  EXPECT_EQ(none.count(), 0U);
  EXPECT_FALSE(none.contains({0, 0}));
}

TEST(BitGrid, HasAComplementInsideItsBorder) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const BitGrid bits = test::random_odd_bits(random);
    BitGrid expected(bits.width(), bits.height());
    for (const Cell cell : test::all_cells(bits.width(), bits.height())) {
      expected.set(cell, !bits[cell]);
    }
    ASSERT_TRUE(bits.complement() == expected);
  }
}

}  // namespace
}  // namespace wend
