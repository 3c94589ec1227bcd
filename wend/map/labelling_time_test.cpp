// The estimate of what components take: by the runs in a sample of the cells.

#include "wend/map/labelling_time.hpp"

#include <gtest/gtest.h>

#include "wend/map/random_bits_test.hpp"
#include "wend/map/word_sample.hpp"

namespace wend {
namespace {

TEST(LabellingTime, GrowsWithTheRuns) {
  BitGrid open(1000, 1000);
  BitGrid stripes = open;
  for (const Cell cell : test::all_cells(1000, 1000)) {
    open.set(cell, true);
    stripes.set(cell, cell.x % 2 == 0);
  }
  EXPECT_GT(labelling_time(open), 200'000U);
  EXPECT_LT(labelling_time(open), 600'000U);
  EXPECT_GT(labelling_time(stripes), 10 * labelling_time(open));
}

TEST(WordSample, StaysOnTheMap) {
  for (const int width : {1, 2, 61, 62, 63, 64, 65, 127, 128, 200}) {
    for (const int height : {1, 2, 50}) {
      const BitGrid cells(width, height);
      std::uint32_t visits = 0;
      visit_sample(cells, [&](int y, std::size_t i, std::uint64_t on_map) {
        ++visits;
        ASSERT_LT(y, height);
        ASSERT_LT(i, cells.row_words(y).size());
        for (std::size_t bit = 0; bit < 64; ++bit) {
          const std::size_t number = 64 * i + bit;  // of cell x: x + 1
          const bool is_cell = number >= 1 && number <= static_cast<std::size_t>(width);
          ASSERT_EQ((on_map >> bit & 1U) != 0, is_cell) << width << ", bit " << number;
        }
      });
      EXPECT_EQ(visits, kSampledWords);
    }
  }
}

}  // namespace
}  // namespace wend
