// Real data: laps along the centrelines of race tracks, and plans on maps of robots. Skipped without
// WEND_DATA.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>

#include "tests/testing/build_paths.hpp"
#include "wend/base/random.hpp"
#include "wend/control/simulation.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

namespace fs = std::filesystem;

constexpr double kDataRadius = 0.2;  // m
constexpr double kMargin = 0.1;      // m

GridMap real_map(const fs::path& file) { return load_map(data_folder() / file)->map; }

class FollowData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (data_folder().empty()) GTEST_SKIP() << "there is no WEND_DATA";
  }
};

class LapOf : public FollowData, public ::testing::WithParamInterface<std::string> {};

TEST_P(LapOf, StaysOnTheTrack) {
  const GridMap map = real_map("tracks/" + GetParam() + "_map.yaml");
  const FreeSpace space = *make_free_space(map, {.footprint = Footprint::disc(kDataRadius)});
  const fs::path file = data_folder() / "tracks" / (GetParam() + "_centerline.csv");
  const Path line = load_path(file, map.frame()).value();
  const auto controller = make_controller("pure_pursuit").value();
  MotionModel model{.drivetrain = Drivetrain::bicycle};
  model.limits = {.speed = 3, .turn_rate = 3, .acceleration = 3, .turn_acceleration = 20};

  const Drive drive = simulate(space, line, *controller, model, {.closed = true});
  EXPECT_EQ(describe(drive.outcome), describe(DriveOutcome::reached));
  EXPECT_EQ(drive.collisions, 0U);
  const double length = Route(line, map.frame(), true).length();
  EXPECT_NEAR(drive.distance, length, 0.02 * length);
  std::cout << GetParam() << ": " << length << " m in " << drive.time
            << " s, largest cross-track error " << drive.cross_track_largest << " m\n";
  EXPECT_LT(drive.cross_track_largest, 0.06);
}

INSTANTIATE_TEST_SUITE_P(Tracks, LapOf,
                         ::testing::Values("Austin", "Monza", "Silverstone", "Spa", "Spielberg"),
                         [](const auto& test) { return test.param; });

class PlansOn : public FollowData, public ::testing::WithParamInterface<std::string> {};

TEST_P(PlansOn, AreDriven) {
  const GridMap map = real_map("ros/" + GetParam() + ".yaml");
  const FreeSpace cautious =
      *make_free_space(map, {.footprint = Footprint::disc(kDataRadius + kMargin)});
  const FreeSpace space = *make_free_space(map, {.footprint = Footprint::disc(kDataRadius)});
  const auto planner = make_planner("astar", cautious).value();
  Random random(1);
  const auto any_cell = [&] {
    return Cell{random.between(0, map.width() - 1), random.between(0, map.height() - 1)};
  };
  constexpr int kPlans = 5;
  for (int plans = 0; plans < kPlans;) {
    const Cell start = any_cell();
    const Cell goal = any_cell();
    if (!cautious.passable(start) || !cautious.passable(goal)) continue;
    const auto plan = planner->plan(Query::between(start, goal));
    if (!plan) continue;
    ++plans;
    const Path smooth = smooth_by_gradient(plan->path, cautious)->path;
    for (const ControllerInfo& info : controllers()) {
      SCOPED_TRACE(info.name + ", plan " + std::to_string(plans));
      const auto controller = info.make({}).value();
      for (const Path& path : {plan->path, smooth}) {
        const Drive drive = simulate(space, path, *controller);
        EXPECT_EQ(describe(drive.outcome), describe(DriveOutcome::reached));
        EXPECT_EQ(drive.collisions, 0U);
        EXPECT_LT(drive.cross_track_largest, kMargin);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, PlansOn,
                         ::testing::Values("pal_small_office/map", "nav2/depot", "nav2/tb3_sandbox",
                                           "aws_warehouse/map", "rmp/warehouse"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace wend::test
