#include "wend/planner/se2/drive.hpp"

#include <gtest/gtest.h>

#include <string>

#include "wend/base/random.hpp"

namespace wend {
namespace {

FreeSpace open_ground(Random& random) {
  Grid<CellState> states(60, 60, CellState::free);
  for (int i = 0; i < 20; ++i) {
    states[{random.between(0, 59), random.between(0, 59)}] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(states), {.footprint = Footprint::disc(0.7)});
}

/// Arcs and lines in both gears, as far as the robot gets.
DrivenMotions random_drive(Random& random, const MotionCheck& check, const Steering& steering) {
  DrivenMotions drive;
  Pose pose{30.5, 30.5, 2 * kPi * random.uniform() - kPi};
  if (!check.free_space().fits(pose)) return drive;
  for (int i = 0; i < 12; ++i) {
    const auto primitives = steering.primitives();
    const Motion motion =
        steering.scaled(primitives[random.below(primitives.size())], 1 + 5 * random.uniform());
    if (!check.fits(pose, motion)) continue;
    drive.push_back({pose, motion});
    pose = pose_after(pose, motion);
  }
  return drive;
}

TEST(DriveShortener, NeverMakesADriveDearerAndKeepsItsEnds) {
  for (const double gear_change : {0.0, 0.3, 4.0}) {
    for (const DriveKind kind :
         {DriveKind::reeds_shepp, DriveKind::dubins, DriveKind::differential}) {
      double saved = 0;
      for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const MotionCheck check(open_ground(random));
        const Steering steering(kind, 3, {.gear_change = gear_change});
        const DrivenMotions drive = random_drive(random, check, steering);
        if (drive.empty()) continue;
        DrivenMotions shorter = drive;
        DriveShortener(check, steering, 4).shorten(shorter);
        const double before = cost_of(drive, check, steering);
        const double after = cost_of(shorter, check, steering);
        EXPECT_LE(after, before + 1e-9);
        saved += before - after;
        const Pose end = pose_after(drive.back().from, drive.back().motion);
        Pose pose = drive.front().from;
        for (const DrivenMotion& driven : shorter) {
          EXPECT_LT(straight_distance(pose.point(), driven.from.point()), 1e-6);
          EXPECT_TRUE(check.fits(driven.from, driven.motion));
          pose = pose_after(driven.from, driven.motion);
        }
        EXPECT_LT(straight_distance(pose.point(), end.point()), 1e-6);
        EXPECT_LT(std::abs(wrapped_angle(pose.heading - end.heading)), 1e-6);
      }
      EXPECT_GT(saved, 0);
    }
  }
}

TEST(DriveCost, CountsChangesOfGearButNotTurnsInPlace) {
  const MotionCheck check(
      *make_free_space(*make_grid_map(Grid<CellState>(20, 20, CellState::free)), {}));
  const Steering steering(DriveKind::differential, 0, {.reverse = 2, .gear_change = 5, .spin = 1});
  const Pose from{10, 10, 0};
  const DrivenMotions drive{
      {from, {2, 0, 0}}, {{12, 10, 0}, {0, 0.5, 0}}, {{12, 10, 0.5}, {-1, 0, 0}}};
  EXPECT_NEAR(cost_of(drive, check, steering), 2 + 0.5 + 2 + 5, 1e-9);
}

TEST(DriveJoin, PutsMotionsOfTheSameCurvatureTogether) {
  DrivenMotions drive{
      {{0, 0, 0}, {1, 0.1, 0}}, {{}, {2, 0.2, 0}}, {{}, {1, 0, 0}}, {{}, {-1, 0, 0}}};
  join(drive);
  ASSERT_EQ(drive.size(), 3U);
  EXPECT_DOUBLE_EQ(drive[0].motion.length, 3);
  EXPECT_DOUBLE_EQ(drive[0].motion.turn, 0.1 + 0.2);
  EXPECT_EQ(drive[2].motion.length, -1);
}

}  // namespace
}  // namespace wend
