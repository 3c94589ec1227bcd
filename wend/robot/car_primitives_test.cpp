#include "wend/robot/car_primitives.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string_view>

#include "wend/geometry/angle.hpp"
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

constexpr std::array<int, kCarMoves> kSides{0, 1, -1, 0, 1, -1};

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
      EXPECT_NEAR(arc.curvature, kSides[static_cast<std::size_t>(move)], 1e-15);
      const Pose end = end_of(arc);
      EXPECT_NEAR(distance(end.point(), to.point()), 0, 1e-15);
      EXPECT_NEAR(std::abs(normalized_angle(end.heading - to.heading)), 0, 1e-15);
    }
  }
}

/// Of the table that the moves once were.
TEST(CarMove, IsAsLongAsEver) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    const bool turn = kSides[static_cast<std::size_t>(number)] != 0;
    EXPECT_EQ(is_turn(move), turn);
    EXPECT_EQ(is_reverse(move), number >= 3);
    EXPECT_EQ(length_of(move), turn ? 1.5707963267948966 : 1.0);
  }
}

TEST(CarMove, RightIsRightOnAPage) {
  for (const Frame& frame : {Frame{}, Frame{.y_up = true}}) {
    for (int number = 0; number < kCarMoves; ++number) {
      const auto move = static_cast<CarMove>(number);
      const Cell to = moved({{0, 0}, Heading::plus_x}, move).vertex;
      const int up = frame.y_up ? to.y : -to.y;
      const std::string_view name = name_of(move, frame);
      EXPECT_EQ(name.starts_with("FWD"), to.x > 0) << name;
      EXPECT_EQ(name.starts_with("REV"), to.x < 0) << name;
      EXPECT_EQ(name.ends_with("RIGHT"), up < 0) << name;
      EXPECT_EQ(name.ends_with("LEFT"), up > 0) << name;
    }
  }
}

TEST(CarPrimitives, AreInTheOrderOfHeadingsAndMoves) {
  const MotionPrimitives& set = car_primitives();
  EXPECT_EQ(set.vertices(), Vertices::corners);
  EXPECT_EQ(set.all().size(), std::size_t{kHeadings} * kCarMoves);
  for (const Heading heading : kAllHeadings) {
    EXPECT_EQ(set.headings()[static_cast<std::size_t>(heading)], radians_of(heading));
    EXPECT_EQ(set.nearest_heading(radians_of(heading)), static_cast<int>(heading));
    for (int number = 0; number < kCarMoves; ++number) {
      EXPECT_EQ(primitive_of(heading, static_cast<CarMove>(number)).number, number);
    }
  }
}

}  // namespace
}  // namespace wend
