// Every controller, with default gains, drives 200 plans through offices and warehouses to their
// goals, as planned, smoothed and with what can be left out left out: planned for a robot that is a
// margin larger, driven without a collision of the robot itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/control/simulation.hpp"
#include "wend/generate/generators.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kRobotRadius = 0.2;  // m
constexpr double kRobotMargin = 0.1;  // m, between the disc that is planned for and the robot
constexpr int kMapsOfAKind = 100;
constexpr double kLeastWay = 20;  // cells

struct PlannedDrive {
  std::string name;
  FreeSpace cautious;  // of what is planned for
  FreeSpace space;     // of the robot itself
  Path path;
};

Cell random_passable(Random& random, const FreeSpace& space) {
  for (;;) {
    const Cell cell{random.between(0, space.width() - 1), random.between(0, space.height() - 1)};
    if (space.passable(cell)) return cell;
  }
}

/// Between random cells that are joined, and not too near.
Path random_plan(const FreeSpace& space, Random& random) {
  const auto planner = make_planner("astar", space).value();
  for (;;) {
    const Cell goal = random_passable(random, space);
    const Cell start = random_passable(random, space);
    const auto plan = planner->plan(Query::between(start, goal));
    if (plan && plan->path.length() >= kLeastWay) return plan->path;
  }
}

std::vector<PlannedDrive> planned_drives() {
  std::vector<PlannedDrive> drives;
  for (const auto& [kind, width, height] :
       {std::tuple("office", 120, 90), std::tuple("warehouse", 150, 110)}) {
    for (int seed = 1; seed <= kMapsOfAKind; ++seed) {
      const GridMap map = make_map(kind, width, height, seed).value();
      Random random(static_cast<std::uint64_t>(seed));
      const FreeSpace cautious =
          *make_free_space(map, {.footprint = Footprint::disc(kRobotRadius + kRobotMargin)});
      drives.push_back({std::string(kind) + " " + std::to_string(seed), cautious,
                        *make_free_space(map, {.footprint = Footprint::disc(kRobotRadius)}),
                        random_plan(cautious, random)});
    }
  }
  return drives;
}

/// Drives a path and checks that all went well; gives the largest cross-track error.
double largest_error(const PlannedDrive& plan, const Path& path, Controller& controller) {
  const Drive drive = simulate(plan.space, path, controller);
  EXPECT_EQ(describe(drive.outcome), describe(DriveOutcome::reached))
      << "at " << drive.time << " s";
  EXPECT_EQ(drive.collisions, 0U);
  EXPECT_LE(drive.final_error, FollowerOptions{}.goal_tolerance);
  return drive.cross_track_largest;
}

class Follow : public ::testing::TestWithParam<std::string> {};

TEST_P(Follow, ReachesTheGoalOfEveryPlan) {
  const auto controller = make_controller(GetParam()).value();
  double as_planned = 0;
  double smoothed = 0;
  double pulled = 0;
  for (const PlannedDrive& plan : planned_drives()) {
    SCOPED_TRACE(plan.name);
    as_planned = std::max(as_planned, largest_error(plan, plan.path, *controller));
    const Path smooth = smooth_by_gradient(plan.path, plan.cautious)->path;
    smoothed = std::max(smoothed, largest_error(plan, smooth, *controller));
    const Path straight = *string_pulled(plan.path, plan.cautious);
    pulled = std::max(pulled, largest_error(plan, straight, *controller));
  }
  std::cout << GetParam() << ": worst cross-track error " << as_planned << " m as planned, "
            << smoothed << " m smoothed, " << pulled << " m pulled straight\n";
  EXPECT_LT(as_planned, kRobotMargin);
  EXPECT_LT(smoothed, kRobotMargin);
  EXPECT_LT(pulled, kRobotMargin);
}

INSTANTIATE_TEST_SUITE_P(Controllers, Follow, ::testing::ValuesIn(controllers().names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
