#include "wend/geometry/curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {
namespace {

using enum Turn;

double number_in(double least, double greatest) {
  constexpr int kSteps = 1000000;
  return least + (greatest - least) * *rc::gen::inRange(0, kSteps + 1) / kSteps;
}

Curve curve_through(const std::vector<CurvePiece>& pieces) {
  Curve curve;
  std::ranges::copy(pieces, curve.pieces.begin());
  curve.count = static_cast<int>(pieces.size());
  return curve;
}

/// Drives in small steps, by the midpoint rule.
Pose driven(const CurvePiece& piece, Pose pose, double radius) {
  constexpr int kSteps = 2000;
  const double step = piece.length / kSteps;
  const double turn = step * static_cast<double>(piece.turn) / radius;
  for (int i = 0; i < kSteps; ++i) {
    const double middle = pose.heading + turn / 2;
    pose = {pose.x + step * std::cos(middle), pose.y + step * std::sin(middle),
            pose.heading + turn};
  }
  return pose;
}

Curve random_curve(double radius) {
  std::vector<CurvePiece> pieces;
  const int count = *rc::gen::inRange(0, 6);
  for (int i = 0; i < count; ++i) {
    const auto turn = static_cast<Turn>(*rc::gen::inRange(-1, 2));
    const double length = number_in(-6 * radius, 6 * radius);
    if (length != 0) pieces.push_back({length, turn});
  }
  return curve_through(pieces);
}

RC_GTEST_PROP(Curve, EndsWhereACarDrives, ()) {
  const double radius = number_in(0.5, 5);
  const double x = number_in(-9, 9);
  const double heading = number_in(-7, 7);
  const Pose from{x, 2, heading};
  const Curve curve = random_curve(radius);
  Pose pose = from;
  for (const CurvePiece& piece : curve.driven()) pose = driven(piece, pose, radius);
  const Pose end = end_of(curve, from, radius);
  RC_ASSERT(distance(end.point(), pose.point()) < 1e-3);
  RC_ASSERT(std::abs(normalized_angle(end.heading - pose.heading)) < 1e-9);
}

RC_GTEST_PROP(Curve, IsDividedIntoArcsThatItsPosesGiveBack, ()) {
  const double radius = number_in(0.5, 5);
  const double heading = number_in(-3, 3);
  const Pose from{1, 2, heading};
  const Curve curve = random_curve(radius);
  std::vector<Arc> arcs;
  append_arcs(curve, from, radius, arcs);
  std::vector<Pose> poses{from};
  append_poses(curve, from, radius, poses);

  RC_ASSERT(poses.size() == arcs.size() + 1);
  double length = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Segment between = segment_between(poses[i], poses[i + 1]);
    RC_ASSERT(std::abs(arcs[i].turn()) <= kPi / 2 + 1e-9);
    RC_ASSERT(std::abs(between.length - arcs[i].length) < 1e-9);
    RC_ASSERT(std::abs(between.turn - arcs[i].turn()) < 1e-9);
    RC_ASSERT(std::abs(between.course) < 1e-8);
    RC_ASSERT(distance(end_of(arcs[i]).point(), poses[i + 1].point()) < 1e-9);
    length += std::abs(arcs[i].length);
  }
  RC_ASSERT(std::abs(length - curve.length()) < 1e-9);
  const Pose end = end_of(curve, from, radius);
  RC_ASSERT(distance(poses.back().point(), end.point()) < 1e-9);
  RC_ASSERT(std::abs(normalized_angle(poses.back().heading - end.heading)) < 1e-9);
}

TEST(Curve, DividesArcsOfMoreThanAQuarterTurnOnly) {
  constexpr double kRound = 4 * kPi;  // of the radius 2
  std::vector<Arc> arcs;
  append_arcs(curve_through({{kRound / 4, left}, {50, straight}, {-kRound * 0.6, right}}),
              {0, 0, 0}, 2, arcs);
  ASSERT_EQ(arcs.size(), 5U);
  EXPECT_EQ(arcs[0].length, kRound / 4);
  EXPECT_EQ(arcs[1].length, 50);
  for (const std::size_t third : {2U, 3U, 4U}) {
    EXPECT_NEAR(arcs[third].length, -kRound / 5, 1e-12);
    EXPECT_EQ(arcs[third].curvature, -0.5);
  }
}

TEST(CurveCosts, WeighReverseArcsAndChangesOfGear) {
  const CurveCosts costs{.reverse = 2, .turn = 1.5, .gear_change = 10};
  const Curve curve =
      curve_through({{1, left}, {2, straight}, {-3, right}, {-4, straight}, {5, left}});
  EXPECT_EQ(cost_of(curve.driven(), costs), 1.5 + 2 + 9 + 8 + 7.5 + 2 * 10);
  EXPECT_EQ(curve.gear_changes(), 2);
  EXPECT_EQ(curve.length(), 15);
  EXPECT_EQ(cost_of(curve.driven(), {}), 15);
}

TEST(CurveCosts, CountNoGearOfAPieceOfLengthZero) {
  const std::vector<CurvePiece> pieces{{-0.0, left}, {2, straight}, {0, right}, {1, left}};
  EXPECT_EQ(cost_of(pieces, {.gear_change = 10}), 3);
}

TEST(Curve, ThatDoesNotExistIsNotTheOneOfLengthZero) {
  EXPECT_FALSE(Curve{}.exists());
  const Pose pose{3, 4, 5};
  const Curve none = cheapest_reeds_shepp(pose, pose, 1);
  EXPECT_TRUE(none.exists());
  EXPECT_EQ(none.cost, 0);
  EXPECT_EQ(none.count, 0);
}

}  // namespace
}  // namespace wend
