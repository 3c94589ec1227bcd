#include "wend/path/smoothing/drive_smoother.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_arc.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"

namespace wend {
namespace {

constexpr double kLeastRadius = 4;  // cells
constexpr int kRoom = 40;           // cells

/// Cells with a few blocks in them, and a robot of 3 x 2 cells.
FreeSpace cluttered(Random& random) {
  Grid<CellState> cells(kRoom, kRoom, CellState::free);
  for (int i = 0; i < 10; ++i) {
    cells[{random.between(0, kRoom - 1), random.between(0, kRoom - 1)}] = CellState::occupied;
  }
  const Footprint box = *Footprint::polygon(*Polygon::make({{2, 1}, {-1, 1}, {-1, -1}, {2, -1}}));
  return *make_free_space(*make_grid_map(cells), {.footprint = box});
}

Pose random_stand(Random& random) {
  return {test::number_between(random, 3, kRoom - 3), test::number_between(random, 3, kRoom - 3),
          test::number_between(random, -kPi, kPi)};
}

/// Reeds-Shepp curves through some poses, if the robot fits along them.
std::optional<Path> random_drive(Random& random, const FreeSpace& space) {
  std::vector<Pose> poses{random_stand(random)};
  for (int legs = random.between(1, 3); legs > 0; --legs) {
    const Pose from = poses.back();
    const Curve curve = cheapest_reeds_shepp(from, random_stand(random), kLeastRadius);
    append_poses(curve, from, kLeastRadius, poses);
  }
  Path path = Path::through(std::move(poses));
  if (first_collision(path, space)) return std::nullopt;
  return path;
}

/// By the poses each hundredth of a cell, with what a sweep counts as touching left out.
bool fits_everywhere(const Path& path, const FreeSpace& space) {
  for (const Segment& segment : path.segments()) {
    const int steps = static_cast<int>(std::abs(segment.length) / 0.01) + 1;
    for (int i = 0; i <= steps; ++i) {
      if (!space.fits(pose_on(segment, static_cast<double>(i) / steps))) return false;
    }
  }
  return true;
}

double smallest_radius(const Path& path) {
  double radius = kLeastRadius;
  for (const Segment& segment : path.segments()) {
    radius = std::min(radius, std::abs(segment.length / segment.turn));
  }
  return radius;
}

RC_GTEST_PROP(DriveSmoother, KeepsEndsRadiusAndFreedomAndLowersItsSum, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  const auto longer = *rc::gen::element(0.0, 0.05, 0.2);
  Random random(seed);
  const FreeSpace space = cluttered(random);
  const auto path = random_drive(random, space);
  if (!path) return;
  const DriveSmootherOptions options{.clearance = 1, .longer = longer};
  const auto smoothed = smooth_drive(*path, space, options);
  RC_ASSERT(smoothed.has_value());
  const Path& result = smoothed->path;
  RC_ASSERT(result.driven_poses().front() == path->driven_poses().front());
  RC_ASSERT(result.driven_poses().back() == path->driven_poses().back());
  // In arcs that are very short, rounding makes the curvature of the given path a little larger.
  const double tightest = smallest_radius(*path);
  RC_ASSERT(tightest > 0.999 * kLeastRadius);
  for (const Segment& segment : result.segments()) {
    RC_ASSERT(std::abs(segment.course) < 1e-6);
    RC_ASSERT(std::abs(segment.turn) * tightest <= std::abs(segment.length) * (1 + 1e-6));
  }
  RC_ASSERT(!first_collision(result, space));
  RC_ASSERT(fits_everywhere(result, space));
  RC_ASSERT(result.length() <= path->length() * (1 + longer) + 1e-9);
  const double before = *drive_roughness(*path, space, options);
  const double after = *drive_roughness(result, space, options);
  RC_ASSERT(after <= before * (1 + 1e-9));
  RC_CLASSIFY(after < 0.95 * before, "by 5 % or more");
  RC_CLASSIFY(measure(*path, space)->reversals > 0, "with changes of gear");
}

TEST(DriveSmoother, WidensAnArcBetweenLines) {
  const FreeSpace space = test::open_space(60, 60);
  const Path sharp =
      Path::through({{10, 10, 0}, {40, 10, 0}, {44, 14, kPi / 2}, {44, 44, kPi / 2}});
  const auto smoothed = smooth_drive(sharp, space, {.clearance = 0});
  ASSERT_TRUE(smoothed);
  EXPECT_GT(measure(smoothed->path, space)->smallest_turning_radius, 2 * kLeastRadius);
  EXPECT_LT(smoothed->path.length(), sharp.length()) << "a wide arc cuts the corner";
  EXPECT_TRUE(smoothed->within_bound);
}

TEST(DriveSmoother, MovesAChangeOfGearAndKeepsTheGears) {
  const FreeSpace space = test::open_space(60, 60);
  const Pose from{20, 20, 0};
  std::vector<Pose> poses{from};
  append_poses(cheapest_reeds_shepp(from, {20, 26, 0}, kLeastRadius), from, kLeastRadius, poses);
  const Path parking = Path::through(poses);
  const auto smoothed = smooth_drive(parking, space, {.clearance = 0, .longer = 0.3});
  ASSERT_TRUE(smoothed);
  EXPECT_NE(smoothed->path, parking);
  EXPECT_EQ(measure(smoothed->path, space)->reversals, measure(parking, space)->reversals);
}

TEST(DriveSmoother, LeavesAStraightPathAndTurnsInPlaceAsTheyAre) {
  const FreeSpace space = test::open_space(60, 60);
  const Path straight = Path::through({{10, 10, 0}, {40, 10, 0}});
  EXPECT_EQ(smooth_drive(straight, space)->path, straight);
  const Path turning = Path::through({{10, 10, 0}, {40, 10, 0}, {40, 10, kPi / 2}});
  EXPECT_EQ(smooth_drive(turning, space)->path, turning);
}

TEST(DriveSmoother, SaysWhatIsWrong) {
  const FreeSpace space = test::open_space(60, 60);
  const Path path = Path::through({{10, 10, 0}, {40, 10, 0}});
  EXPECT_EQ(smooth_drive(path, space, {.alpha = -1}).error().status, Status::invalid_option);
  EXPECT_EQ(smooth_drive(Path::along({{1, 1}, {2, 2}}), space).error().status,
            Status::unsupported_query);
  EXPECT_EQ(smooth_drive(Path::through({{10, 10, 0}, {80, 10, 0}}), space).error().status,
            Status::unsupported_query);
  const Path tight = Path::through({{10, 10, 0}, {12, 12, kPi / 2}});
  EXPECT_FALSE(smooth_drive(tight, space, {.turning_radius = 4})->within_bound);
}

TEST(Refinement, SmoothsAPathOfPosesByTheSmootherOfDrives) {
  const FreeSpace space = test::open_space(60, 60);
  const Path sharp =
      Path::through({{10, 10, 0}, {40, 10, 0}, {44, 14, kPi / 2}, {44, 44, kPi / 2}});
  const auto refined_drive = refined(sharp, space, {.smoother = SmootherChoice{}});
  ASSERT_TRUE(refined_drive);
  EXPECT_TRUE(refined_drive->path.driven());
  EXPECT_EQ(refined_drive->path, smooth_drive(sharp, space)->path);
}

}  // namespace
}  // namespace wend
