#include "wend/geometry/car_move.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wend/geometry/arc.hpp"

namespace wend {
namespace {

TEST(CarMove, MovesAsTheReferenceTableSays) {
  const CornerPose from{{1, 0}, Heading::plus_x};
  EXPECT_EQ(moved(from, CarMove::fwd), (CornerPose{{2, 0}, Heading::plus_x}));
  EXPECT_EQ(moved(from, CarMove::fwd_plus), (CornerPose{{2, 1}, Heading::plus_y}));
  EXPECT_EQ(moved(from, CarMove::fwd_minus), (CornerPose{{2, -1}, Heading::minus_y}));
  EXPECT_EQ(moved(from, CarMove::rev), (CornerPose{{0, 0}, Heading::plus_x}));
  EXPECT_EQ(moved(from, CarMove::rev_plus), (CornerPose{{0, 1}, Heading::minus_y}));
  EXPECT_EQ(moved(from, CarMove::rev_minus), (CornerPose{{0, -1}, Heading::plus_y}));
}

TEST(CarMove, IsAsLongAsAUnit) {
  EXPECT_EQ(moved({{1, 5}, Heading::minus_y}, CarMove::fwd_minus, 3),
            (CornerPose{{-2, 2}, Heading::minus_x}));
}

TEST(CarMove, IsUndoneByItsInverse) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    EXPECT_NE(is_reverse(move), is_reverse(inverse(move)));
    EXPECT_EQ(is_turn(move), is_turn(inverse(move)));
    for (const Heading heading : kAllHeadings) {
      const CornerPose from{{3, 4}, heading};
      EXPECT_EQ(moved(moved(from, move), inverse(move)), from) << number;
    }
  }
}

/// The car drives an arc: the end pose in the table is that of a circle of radius one.
TEST(CarMove, IsAnArcOfItsLength) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    for (const Heading heading : kAllHeadings) {
      const CornerPose from{{3, 4}, heading};
      const Pose to = pose_of(moved(from, move));
      const Arc arc = arc_to(pose_of(from), to.point());
      EXPECT_NEAR(std::abs(arc.length), length_of(move), 1e-15);
      EXPECT_EQ(arc.length < 0, is_reverse(move));
      EXPECT_NEAR(arc.curvature, side_of(move), 1e-15);
      const Pose end = end_of(arc);
      EXPECT_NEAR(distance(end.point(), to.point()), 0, 1e-15);
      EXPECT_NEAR(std::abs(normalized_angle(end.heading - to.heading)), 0, 1e-15);
    }
  }
}

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
