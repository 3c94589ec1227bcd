#include "wend/geometry/corner_pose.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wend {
namespace {

TEST(CornerPose, IsTheNearestOfTheLattice) {
  EXPECT_EQ(nearest_corner_pose({2.4, 3.6, 0.7}), (CornerPose{{2, 4}, Heading::plus_x}));
  EXPECT_EQ(nearest_corner_pose({2.4, 3.6, 0.8}), (CornerPose{{2, 4}, Heading::plus_y}));
  EXPECT_EQ(nearest_corner_pose({2.4, 3.6, -0.8}), (CornerPose{{2, 4}, Heading::minus_y}));
  EXPECT_EQ(nearest_corner_pose({7.4, -3, 0}, 5), (CornerPose{{5, -5}, Heading::plus_x}));
  EXPECT_EQ(nearest_corner_pose({1e12, 0, 0}), std::nullopt);
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nearest_corner_pose({kNothing, 0, 0}), std::nullopt);
  EXPECT_EQ(nearest_corner_pose({0, 0, kNothing}), std::nullopt);
}

}  // namespace
}  // namespace wend
