#include "wend/render/heatmap.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wend {
namespace {

TEST(HeatRange, HoldsTheLargestNumbers) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const HeatRange range{-kMost, kMost};
  EXPECT_EQ(range.share(-kMost), 0);
  EXPECT_EQ(range.share(0), 0.5);
  EXPECT_EQ(range.share(kMost), 1);
}

TEST(ShortNumber, IsShortAndReadable) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(8321), "8321");
  EXPECT_EQ(short_number(123456), "123456");
  EXPECT_EQ(short_number(1250000), "1.25e6");
  EXPECT_EQ(short_number(3e12), "3e12");
  EXPECT_EQ(short_number(0.25), "0.25");
  EXPECT_EQ(short_number(1.41421356), "1.41");
  EXPECT_EQ(short_number(0.0000042), "4.2e-6");
  EXPECT_EQ(short_number(-17), "-17");
  EXPECT_EQ(short_number(1234.5678), "1235");
}

}  // namespace
}  // namespace wend
