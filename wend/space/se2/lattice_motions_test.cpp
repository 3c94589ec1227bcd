#include "wend/space/se2/lattice_motions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace wend {
namespace {

Steering steering_of(DriveKind model, double radius) { return {model, radius, DriveCosts{}}; }

void expect_steps_to_end_on_the_lattice(const LatticeMotions& lattice) {
  for (std::size_t heading = 0; heading < LatticeMotions::kHeadings; ++heading) {
    const Pose from = lattice.pose(7.5, 3, heading);
    EXPECT_EQ(lattice.heading_of(from), heading);
    EXPECT_FALSE(lattice.steps(heading).empty());
    for (const LatticeMotions::Step& step : lattice.steps(heading)) {
      Pose pose = from;
      for (const Motion& motion : step.motions) pose = pose_after(pose, motion);
      const Pose to = lattice.after(from, step);
      EXPECT_EQ(lattice.nearest(to), to);
      EXPECT_NEAR(pose.x, to.x, 1e-9);
      EXPECT_NEAR(pose.y, to.y, 1e-9);
      EXPECT_NEAR(wrapped_angle(pose.heading - to.heading), 0, 1e-9);
    }
  }
}

TEST(LatticeMotions, EndOnPosesOfTheLattice) {
  for (const double radius : {0.3, 1.0, 3.0, 8.0, 47.0}) {
    SCOPED_TRACE("radius " + std::to_string(radius));
    for (const DriveKind model : {DriveKind::reeds_shepp, DriveKind::dubins}) {
      expect_steps_to_end_on_the_lattice(LatticeMotions(steering_of(model, radius)));
    }
  }
  for (const DriveKind model : {DriveKind::differential, DriveKind::omni}) {
    expect_steps_to_end_on_the_lattice(LatticeMotions(steering_of(model, 0)));
  }
}

TEST(LatticeMotions, KeepTheTurningRadiusAndTheGears) {
  for (const double radius : {0.3, 3.0, 8.0}) {
    SCOPED_TRACE("radius " + std::to_string(radius));
    for (const DriveKind model : {DriveKind::reeds_shepp, DriveKind::dubins}) {
      const LatticeMotions lattice(steering_of(model, radius));
      for (std::size_t heading = 0; heading < LatticeMotions::kHeadings; ++heading) {
        for (const LatticeMotions::Step& step : lattice.steps(heading)) {
          for (const Motion& motion : step.motions) {
            EXPECT_LE(std::abs(motion.turn) * radius, std::abs(motion.length) + 1e-9);
            EXPECT_EQ(gear_of(motion), gear_of(step.motions.front()));
            EXPECT_TRUE(motion.length > 0 || model == DriveKind::reeds_shepp);
          }
        }
      }
    }
  }
}

TEST(LatticeMotions, AreNoneWhereTheTurningRadiusIsTooLarge) {
  EXPECT_TRUE(LatticeMotions(steering_of(DriveKind::reeds_shepp, 1e6)).empty());
}

}  // namespace
}  // namespace wend
