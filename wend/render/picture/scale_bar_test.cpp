#include "wend/render/picture/scale_bar.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

TEST(ScaleBar, IsARoundLengthInMetres) {
  const Frame frame{.resolution = 0.05, .metric = true};
  const ScaleBar bar = scale_bar(frame, 2, 200);  // 200 pixels are exactly 5 m
  EXPECT_EQ(bar.label, "5 m");
  EXPECT_DOUBLE_EQ(bar.pixels, 200);
  EXPECT_EQ(scale_bar(frame, 2, 199).label, "2 m");
  EXPECT_EQ(scale_bar(frame, 2, 79).label, "1 m");
  EXPECT_EQ(scale_bar(frame, 100, 200).label, "0.1 m");
  EXPECT_EQ(scale_bar(frame, 0.01, 200).label, "1000 m");
}

TEST(ScaleBar, CountsCellsWithoutMetres) {
  const Frame frame;
  EXPECT_EQ(scale_bar(frame, 10, 200).label, "20 cells");
  EXPECT_EQ(scale_bar(frame, 150, 200).label, "1 cell");
  const ScaleBar wide = scale_bar(frame, 1000, 200);
  EXPECT_EQ(wide.label, "1 cell");
  EXPECT_EQ(wide.pixels, 1000);
}

}  // namespace
}  // namespace wend
