#include "wend/jump/shortcut_graph.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "wend/base/random.hpp"

namespace wend {
namespace {

TEST(CoarseBox, NeverMissesACellBetweenThoseInIt) {
  Random random(41);
  for (int trial = 0; trial < 300; ++trial) {
    const int width = random.between(1, 5000);
    const int height = random.between(1, 5000);
    const CoarseRaster raster(width, height);
    CoarseBox box;
    Cell least{width, height};
    Cell most{0, 0};
    for (int i = random.between(1, 4); i > 0; --i) {
      const int x = random.between(0, width - 1);
      const int y = random.between(0, height - 1);
      box.include(raster.place({x, y}));
      least = {std::min(least.x, x), std::min(least.y, y)};
      most = {std::max(most.x, x), std::max(most.y, y)};
    }
    for (int i = 0; i < 100; ++i) {
      const int x = random.between(least.x, most.x);
      const int y = random.between(least.y, most.y);
      EXPECT_TRUE(box.may_hold(raster.place({x, y}))) << x << ',' << y << " in trial " << trial;
    }
  }
}

TEST(CoarseBox, IsExactOnMapsOfUpTo127Cells) {
  const CoarseRaster raster(127, 40);
  CoarseBox box;
  box.include(raster.place({20, 7}));
  box.include(raster.place({31, 5}));
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 127; ++x) {
      const bool inside = x >= 20 && x <= 31 && y >= 5 && y <= 7;
      EXPECT_EQ(box.may_hold(raster.place({x, y})), inside) << x << ',' << y;
    }
  }
}

TEST(CoarseBox, HoldsNothingAtFirst) {
  const CoarseRaster raster(127, 127);
  for (const int x : {0, 63, 126}) {
    for (const int y : {0, 63, 126}) EXPECT_FALSE(CoarseBox().may_hold(raster.place({x, y})));
  }
}

TEST(CoarseBox, TakesWhatLiesOutsideAsItsEdge) {
  const CoarseRaster raster(300, 200);
  CoarseBox box;
  box.include(raster.place({100, 100}));
  box.include(raster.place({100 + (1 << 20), 100 - (1 << 20)}));
  EXPECT_TRUE(box.may_hold(raster.place({299, 0})));
  EXPECT_FALSE(box.may_hold(raster.place({0, 0})));
}

}  // namespace
}  // namespace wend
