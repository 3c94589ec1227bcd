#include "wend/geometry/car_move.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "wend/geometry/arc.hpp"

namespace wend {
namespace {

constexpr bool kYDown = false;

CornerPose after(CornerPose from, CarMove move, bool y_up = kYDown) {
  return moved(from, move, y_up);
}

TEST(CarMove, MovesAsInTheTextbook) {
  const CornerPose from{{1, 0}, Heading::east};
  EXPECT_EQ(after(from, CarMove::fwd), (CornerPose{{2, 0}, Heading::east}));
  EXPECT_EQ(after(from, CarMove::fwd_right), (CornerPose{{2, 1}, Heading::south}));
  EXPECT_EQ(after(from, CarMove::fwd_left), (CornerPose{{2, -1}, Heading::north}));
  EXPECT_EQ(after(from, CarMove::rev), (CornerPose{{0, 0}, Heading::east}));
  EXPECT_EQ(after(from, CarMove::rev_right), (CornerPose{{0, 1}, Heading::north}));
  EXPECT_EQ(after(from, CarMove::rev_left), (CornerPose{{0, -1}, Heading::south}));
}

TEST(CarMove, TurnsToTheSameSideWithYUp) {
  EXPECT_EQ(moved({{1, 5}, Heading::east}, CarMove::fwd_right, true),
            (CornerPose{{2, 4}, Heading::south}));
  EXPECT_EQ(moved({{1, 5}, Heading::north}, CarMove::fwd_left, true, 3),
            (CornerPose{{-2, 8}, Heading::west}));
}

TEST(CarMove, IsUndoneByItsInverse) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    EXPECT_NE(is_reverse(move), is_reverse(inverse(move)));
    EXPECT_EQ(is_turn(move), is_turn(inverse(move)));
    for (const Heading heading : kAllHeadings) {
      const CornerPose from{{3, 4}, heading};
      EXPECT_EQ(after(after(from, move), inverse(move)), from) << to_string(move);
    }
  }
}

/// The car drives the arc: the end that the table gives is that of a circle of radius one.
TEST(CarMove, IsAnArcOfItsLength) {
  for (const bool y_up : {false, true}) {
    for (int number = 0; number < kCarMoves; ++number) {
      const auto move = static_cast<CarMove>(number);
      for (const Heading heading : kAllHeadings) {
        const CornerPose from{{3, 4}, heading};
        const Pose to = pose_of(moved(from, move, y_up), y_up);
        const Arc arc = arc_to(pose_of(from, y_up), to.point());
        EXPECT_NEAR(std::abs(arc.length), length_of(move), 1e-15);
        EXPECT_EQ(arc.length < 0, is_reverse(move));
        EXPECT_NEAR(std::abs(arc.curvature), is_turn(move) ? 1 : 0, 1e-15);
        const Pose end = end_of(arc);
        EXPECT_NEAR(distance(end.point(), to.point()), 0, 1e-15);
        EXPECT_NEAR(std::abs(normalized_angle(end.heading - to.heading)), 0, 1e-15);
      }
    }
  }
}

TEST(CarMove, HasAName) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    EXPECT_EQ(car_move_from_string(to_string(move)), move);
  }
  EXPECT_EQ(to_string(CarMove::rev_left), "REV_LEFT");
  EXPECT_EQ(car_move_from_string("fwd"), std::nullopt);
}

TEST(CornerPose, IsTheNearestOfTheLattice) {
  EXPECT_EQ(nearest_corner_pose({2.4, 3.6, 0.7}, kYDown), (CornerPose{{2, 4}, Heading::east}));
  EXPECT_EQ(nearest_corner_pose({2.4, 3.6, 0.8}, kYDown), (CornerPose{{2, 4}, Heading::south}));
  EXPECT_EQ(nearest_corner_pose({2.4, 3.6, 0.8}, true), (CornerPose{{2, 4}, Heading::north}));
  EXPECT_EQ(nearest_corner_pose({7.4, -3, 0}, kYDown, 5), (CornerPose{{5, -5}, Heading::east}));
  EXPECT_EQ(nearest_corner_pose({1e12, 0, 0}, kYDown), std::nullopt);
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nearest_corner_pose({kNothing, 0, 0}, kYDown), std::nullopt);
  EXPECT_EQ(nearest_corner_pose({0, 0, kNothing}, kYDown), std::nullopt);
}

}  // namespace
}  // namespace wend
