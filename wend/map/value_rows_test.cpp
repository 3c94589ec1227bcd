#include "wend/map/value_rows.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace wend {
namespace {

TEST(ValueRows, DifferenceIsWhatEachCellSays) {
  std::mt19937 random(11);
  for (int n = 0; n < 2000; ++n) {
    const std::size_t width = 1 + random() % 12;
    const std::size_t height = 1 + random() % 12;
    std::vector<std::int8_t> before(width * height);
    for (auto& value : before) value = static_cast<std::int8_t>(random() % 3);
    std::vector<std::int8_t> after = before;
    for (auto i = random() % 4; i > 0; --i) {
      after[random() % after.size()] = static_cast<std::int8_t>(random() % 3);
    }
    CellBox box;
    std::int64_t cells = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (before[i] == after[i]) continue;
      const Cell cell{static_cast<int>(i % width), static_cast<int>(i / width)};
      box = box.joined_with({cell, {cell.x + 1, cell.y + 1}});
      ++cells;
    }
    const Difference found = difference<std::int8_t>({before, width}, {after, width});
    ASSERT_EQ(found.box, box);
    ASSERT_EQ(found.cells, cells);
  }
}

TEST(ValueRows, APartHasTheValuesOfItsBox) {
  const std::vector<std::int8_t> values{0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23};
  const ValueRows<std::int8_t> rows(values, 4);
  EXPECT_EQ(rows.height(), 3);
  const ValueRows<std::int8_t> part = rows.part({{1, 1}, {3, 3}});
  ASSERT_EQ(part.width(), 2);
  ASSERT_EQ(part.height(), 2);
  EXPECT_EQ(part.row(0)[0], 11);
  EXPECT_EQ(part.row(1)[1], 22);
  EXPECT_EQ((part[{1, 0}]), 12);
  const ValueRows<std::int8_t> corner = part.part({{1, 1}, {2, 2}});
  EXPECT_EQ(corner.row(0)[0], 22);
}

}  // namespace
}  // namespace wend
