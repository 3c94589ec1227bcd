// Parking: what the planner of the car found, forth and back, is driven by pure pursuit, by a robot
// that turns in place and by one that steers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/control/simulation.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kRadius = 0.25;  // m; a cell is 1 m wide, and a car turns with a radius of 1 m
constexpr double kPlannedRadius = 0.35;
constexpr int kDrivenYards = 30;

struct Parking {
  std::string name;
  FreeSpace space;
  Path path;
};

Pose random_stand(Random& random, const GridMap& map) {
  return {static_cast<double>(random.between(1, map.width() - 1)),
          static_cast<double>(random.between(1, map.height() - 1)), kPi / 2 * random.between(0, 3)};
}

/// Drives with reversals through random yards.
std::vector<Parking> parkings() {
  std::vector<Parking> parkings;
  for (int seed = 1; seed <= kDrivenYards; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const GridMap map = make_map("parking", 40, 25, seed).value();
    const FreeSpace cautious =
        *make_free_space(map, {.footprint = Footprint::disc(kPlannedRadius)});
    const auto planner = make_planner("car", cautious).value();
    for (;;) {
      const auto plan =
          planner->plan({random_stand(random, map), {Goal(random_stand(random, map))}});
      if (!plan || measure(plan->path, cautious)->reversals == 0) continue;
      parkings.push_back({"parking " + std::to_string(seed),
                          *make_free_space(map, {.footprint = Footprint::disc(kRadius)}),
                          plan->path});
      break;
    }
  }
  return parkings;
}

class FollowCar : public ::testing::TestWithParam<Drivetrain> {};

TEST_P(FollowCar, ParksForthAndBack) {
  const auto controller = make_controller("pure_pursuit").value();
  const MotionModel model{.drivetrain = GetParam()};
  double worst = 0;
  double worst_heading = 0;
  for (const Parking& parking : parkings()) {
    SCOPED_TRACE(parking.name);
    const Drive drive = simulate(parking.space, parking.path, *controller, model);
    EXPECT_EQ(describe(drive.outcome), describe(DriveOutcome::reached));
    EXPECT_EQ(drive.collisions, 0U);
    EXPECT_NEAR(drive.distance, parking.path.length(), 0.1 * parking.path.length());
    worst = std::max(worst, drive.cross_track_largest);
    worst_heading = std::max(worst_heading, std::abs(drive.final_heading_error));
  }
  std::cout << "pure_pursuit, " << choice_name(GetParam()) << ": worst cross-track error " << worst
            << " m, worst heading at the goal " << worst_heading << " rad\n";
  EXPECT_LT(worst, kPlannedRadius - kRadius);
  EXPECT_LT(worst_heading, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Robots, FollowCar,
                         ::testing::Values(Drivetrain::differential, Drivetrain::bicycle),
                         [](const auto& test) { return std::string(choice_name(test.param)); });

}  // namespace
}  // namespace wend::test
