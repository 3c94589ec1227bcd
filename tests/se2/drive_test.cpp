// From the answer to the wheels: robots of three kinds drive what every planner with headings plans for them, on
// maps of offices, a warehouse, a car park and robots, with every controller that they can obey. Whether a drive has
// reached its goal, and whether it was free, this test finds out by itself. More than a thousand drives.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/testing/build_paths.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/control/simulation.hpp"
#include "wend/control/trajectory_tracker.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kPlanningMargin = 0.1;  // m, as of `wend follow`
constexpr double kHalfLength = 0.3;      // m
constexpr double kHalfWidth = 0.2;       // m
constexpr double kCarRadius = 0.49;      // m, a bit more than the bicycle's
constexpr double kLeastWay = 1;          // m
constexpr double kMostWay = 8;           // m

struct DriverKind {
  std::string name;
  Drivetrain drivetrain;
  std::vector<PlannerSpec> planners;
};

std::vector<DriverKind> driver_kinds() {
  const std::string radius = std::to_string(kCarRadius);
  return {
      {"differential",
       Drivetrain::differential,
       {{"hybrid_astar", {{"motion_model", "differential"}}}, {"lattice", {}}, {"car", {}}}},
      {"car",
       Drivetrain::bicycle,
       {{"hybrid_astar", {{"turning_radius", radius}}},
        {"lattice", {{"turning_radius", radius}}},
        {"car", {{"turning_radius", radius}}}}},
      {"omni", Drivetrain::omni, {{"hybrid_astar", {{"motion_model", "omni"}}}, {"lattice", {}}}}};
}

struct DriveMap {
  std::string name;
  std::string file;  // of the shared data; empty: generated
};

void PrintTo(const DriveMap& map, std::ostream* out) { *out << map.name; }

std::vector<DriveMap> drive_maps() {
  return {{"office", ""},
          {"warehouse", ""},
          {"car_park", ""},
          {"nav2_depot", "ros/nav2/depot.yaml"},
          {"pal_small_office", "ros/pal_small_office/map.yaml"},
          {"aws_warehouse", "ros/aws_warehouse/map.yaml"}};
}

GridMap made(const DriveMap& map) {
  if (map.file.empty()) {
    const GridMap cells = make_map(map.name, 210, 150, 7).value();
    return make_grid_map(cells.occupied(), cells.unknown(), {.resolution = 0.1}, cells.terrain())
        .value();
  }
  return load_map(data_folder() / map.file)->map;
}

const std::vector<Point> kOutline{{kHalfLength, kHalfWidth},
                                  {-kHalfLength, kHalfWidth},
                                  {-kHalfLength, -kHalfWidth},
                                  {kHalfLength, -kHalfWidth}};

/// Does the robot's rectangle keep out of every obstacle? It samples its outline and its middle each centimetre or so,
/// and so finds what overlaps by more than that.
bool stands_free(const GridMap& map, const Pose& pose) {
  constexpr int kSamples = 40;
  const double resolution = map.frame().resolution;
  const auto blocked = [&](double ahead, double left) {
    const double x =
        pose.x + (std::cos(pose.heading) * ahead - std::sin(pose.heading) * left) / resolution;
    const double y =
        pose.y + (std::sin(pose.heading) * ahead + std::cos(pose.heading) * left) / resolution;
    const Cell cell{static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
    return !map.contains(cell) || map.occupied()[cell] || map.unknown()[cell];
  };
  constexpr double kShrunk = 0.999;  // it may touch
  for (std::size_t i = 0; i < kOutline.size(); ++i) {
    const Point a = kOutline[i];
    const Point b = kOutline[(i + 1) % kOutline.size()];
    for (int k = 0; k < kSamples; ++k) {
      const double share = k / static_cast<double>(kSamples);
      if (blocked(kShrunk * (a.x + share * (b.x - a.x)), kShrunk * (a.y + share * (b.y - a.y)))) {
        return false;
      }
    }
  }
  return !blocked(0, 0);
}

/// By the test's own reckoning.
std::string fault_of(const Drive& drive, const GridMap& map, const Path& path) {
  if (drive.outcome == DriveOutcome::refused) return "refused: " + drive.refusal;
  if (drive.collisions != 0) return "it collided";
  for (const DriveSample& sample : drive.samples) {
    if (!stands_free(map, sample.pose)) return "a sample overlaps an obstacle";
  }
  if (drive.outcome != DriveOutcome::reached) return "";
  const DriveSample& last = drive.samples.back();
  const Pose& goal = path.driven_poses().back();
  const double gap =
      std::hypot(last.pose.x - goal.x, last.pose.y - goal.y) * map.frame().resolution;
  const double turned = std::remainder(last.pose.heading - goal.heading, 2 * kPi);
  if (last.velocity != Velocity{}) return "it still moves at the goal";
  if (gap > 0.1) return "reached " + std::to_string(gap) + " m beside the goal";
  if (std::abs(turned) > 0.1) return "reached turned by " + std::to_string(turned) + " rad";
  return "";
}

/// However little: a tracker of trajectories drives on wheels.
bool steps_aside(const Path& path) {
  return std::ranges::any_of(path.segments(),
                             [](const Segment& way) { return std::abs(way.course) > 1e-6; });
}

/// The drives with every controller that fits.
std::map<std::string, Drive> drives_along(const Path& path, const FreeSpace& space,
                                          const MotionModel& model) {
  std::map<std::string, Drive> drives;
  for (const ControllerInfo& info : controllers()) {
    if (why_unfit(info, model)) continue;
    drives.emplace(info.name, simulate(space, path, *info.make({}).value(), model));
  }
  if (steps_aside(path)) return drives;
  const auto trajectory = Trajectory::along(path, space.map().frame(),
                                            {.speed = model.limits.speed,
                                             .turn_rate = model.limits.turn_rate,
                                             .acceleration = model.limits.acceleration,
                                             .turn_acceleration = model.limits.turn_acceleration});
  EXPECT_TRUE(trajectory);
  TrajectoryTracker tracker(*trajectory);
  drives.emplace("trajectory", simulate(space, path, tracker, model));
  return drives;
}

/// A free one, where such a planner has its states: anywhere, in the middle of a cell, at a vertex.
Pose random_pose(Random& random, const FreeSpace& space, const Planner& planner,
                 const std::string& name) {
  const PlaceGrid places = planner.place_grid();
  for (;;) {
    Pose pose{random.uniform() * space.width(), random.uniform() * space.height(),
              normalized_angle(2 * kPi * random.uniform())};
    if (name != "hybrid_astar") {
      const Point place = places.point(
          {static_cast<int>(pose.x / places.spacing), static_cast<int>(pose.y / places.spacing)});
      pose = {place.x, place.y, kPi / 2 * std::round(pose.heading / (kPi / 2))};
    }
    if (space.fits(pose)) return pose;
  }
}

/// Between random poses that are neither near nor far.
Path random_drive(Random& random, Planner& planner, const std::string& name,
                  const FreeSpace& cautious) {
  const double resolution = cautious.map().frame().resolution;
  constexpr int kTries = 10'000;
  for (int tries = 0; tries < kTries; ++tries) {
    const Pose start = random_pose(random, cautious, planner, name);
    const Pose goal = random_pose(random, cautious, planner, name);
    const double way = distance(start.point(), goal.point()) * resolution;
    if (way < kLeastWay || way > kMostWay) continue;
    Query query{start, {Goal(goal)}};
    query.limits.expansions = 20'000;
    const auto plan = planner.plan(query);
    if (plan && plan->path.length() > 0) return plan->path;
  }
  ADD_FAILURE() << name << " finds no drives";
  return {};
}

struct Tally {
  int drives = 0;
  int reached = 0;
};

class Drives : public ::testing::TestWithParam<DriveMap> {
 protected:
  void SetUp() override {
    if (!GetParam().file.empty() && data_folder().empty()) {
      GTEST_SKIP() << "there is no WEND_DATA";
    }
  }

  /// So many plans of each planner for each kind of robot.
  static void drive(int plans) {
    const GridMap map = made(GetParam());
    const Footprint footprint = Footprint::polygon(Polygon::make(kOutline).value()).value();
    const FreeSpace space = *make_free_space(map, {.footprint = footprint});
    const FreeSpace cautious =
        *make_free_space(map, {.footprint = footprint.grown(kPlanningMargin)});
    Tally tally;
    std::map<std::string, Tally> tallies;
    for (const DriverKind& kind : driver_kinds()) {
      for (const PlannerSpec& spec : kind.planners) {
        const auto planner = make_planner(spec.name, cautious, spec.options).value();
        Random random(17);
        for (int i = 0; i < plans; ++i) {
          const Path path = random_drive(random, *planner, spec.name, cautious);
          for (const auto& [name, driven] :
               drives_along(path, space, {.drivetrain = kind.drivetrain})) {
            const std::string what = kind.name + ", " + spec.name + ", " + name;
            EXPECT_EQ(fault_of(driven, map, path), "") << what << ", drive " << i;
            const bool reached = driven.outcome == DriveOutcome::reached;
            for (Tally* each : {&tally, &tallies[name]}) {
              ++each->drives;
              each->reached += reached ? 1 : 0;
            }
            if (!reached)
              std::cout << what << ", drive " << i << ": " << describe(driven.outcome) << ", "
                        << driven.final_error << " m and " << driven.final_heading_error
                        << " rad off, " << driven.cross_track_largest << " m beside the path\n";
          }
        }
      }
    }
    std::cout << GetParam().name << ": " << tally.reached << " of " << tally.drives << " reached\n";
    for (const auto& [name, its] : tallies) {
      std::cout << "  " << name << ": " << its.reached << " of " << its.drives << "\n";
    }
    EXPECT_GE(tally.reached, 0.99 * tally.drives);
  }
};

TEST_P(Drives, EndWithinTheTolerancesWithoutACollision) { drive(5); }

INSTANTIATE_TEST_SUITE_P(Maps, Drives, ::testing::ValuesIn(drive_maps()),
                         [](const auto& test) { return test.param.name; });

/// Robots that turn in place, through an office, with what drives poses if nobody asks for a controller.
TEST(DefaultController, DrivesThreeHundredTimesWithoutACollision) {
  const GridMap map = made({"office", ""});
  const Footprint footprint = Footprint::polygon(Polygon::make(kOutline).value()).value();
  const FreeSpace space = *make_free_space(map, {.footprint = footprint});
  const FreeSpace cautious = *make_free_space(map, {.footprint = footprint.grown(kPlanningMargin)});
  const auto planner =
      make_planner("hybrid_astar", cautious, {{"motion_model", "differential"}}).value();
  Random random(5);
  for (int i = 0; i < share_of(300); ++i) {
    const Path path = random_drive(random, *planner, "hybrid_astar", cautious);
    const auto controller = make_controller(default_controller(path)).value();
    const Drive drive = simulate(space, path, *controller);
    EXPECT_EQ(fault_of(drive, map, path), "") << "drive " << i;
    EXPECT_EQ(describe(drive.outcome), describe(DriveOutcome::reached)) << "drive " << i;
  }
}

}  // namespace
}  // namespace wend::test
