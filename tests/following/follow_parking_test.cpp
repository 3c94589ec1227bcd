// Parking by hybrid_astar: perpendicular and parallel, forth and back. Trajectories stop at changes of gear, and
// a simulated car that steers follows the drive with pure pursuit and with the Stanley controller.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/base/random.hpp"
#include "wend/control/simulation.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kCell = 0.05;       // m
constexpr double kTurnRadius = 0.5;  // m, of the planned arcs; the bicycle turns with 0.44 m
constexpr double kTolerance = 0.05;  // m, at the goal
constexpr double kGrown = 0.06;      // m, by which the planned robot is larger on every side

void block(Grid<CellState>& cells, double x, double y, double width, double height) {
  const auto cell = [](double metres) { return static_cast<int>(std::round(metres / kCell)); };
  for (int j = cell(y); j < cell(y + height); ++j) {
    for (int i = cell(x); i < cell(x + width); ++i) cells[{i, j}] = CellState::occupied;
  }
}

/// A lane of 1.5 m; above it a row of bays between cars, below it gaps between cars at the kerb.
GridMap street() {
  Grid<CellState> cells(160, 80, CellState::free);
  for (const double x : {0.0, 1.2, 2.4, 3.6, 4.8, 6.0, 7.2}) block(cells, x, 2.6, 0.5, 1.0);
  block(cells, 0, 3.6, 8, 0.4);
  for (const double x : {0.0, 2.7, 5.4}) block(cells, x, 0.4, 1.0, 0.6);
  block(cells, 0, 0, 8, 0.4);
  return *make_grid_map(cells, {.resolution = kCell, .metric = true});
}

Footprint rectangle(double grown) {
  const double x = 0.3 + grown;
  const double y = 0.2 + grown;
  return *Footprint::polygon(*Polygon::make({{x, y}, {-x, y}, {-x, -y}, {x, -y}}));
}

FreeSpace street_for(double grown) {
  return *make_free_space(street(), {.footprint = rectangle(grown)});
}

/// In metres.
Pose stand(double x, double y, double degrees) {
  return {x / kCell, y / kCell, radians_from(degrees)};
}

struct Manoeuvre {
  std::string name;
  Path path;
};

std::vector<Manoeuvre> manoeuvres() {
  const auto planner = make_planner("hybrid_astar", street_for(kGrown),
                                    {{"turning_radius", format_number(kTurnRadius)}})
                           .value();
  const Pose lane = stand(2, 1.8, 0);
  const std::vector<std::tuple<std::string, Pose, Pose>> ends{
      {"perpendicular, nose in", lane, stand(4.45, 3.0, 90)},
      {"perpendicular, nose out", lane, stand(4.45, 3.0, -90)},
      {"out of a bay", stand(2.05, 3.0, 90), stand(6, 1.8, 180)},
      {"parallel", lane, stand(4.5, 0.72, 0)},
      {"parallel, against the lane", stand(6, 1.8, 180), stand(4.5, 0.72, 180)},
      {"out of a gap", stand(4.5, 0.72, 0), stand(6, 1.8, 0)}};
  std::vector<Manoeuvre> found;
  for (const auto& [name, from, to] : ends) {
    const auto plan = planner->plan({from, {Goal(to)}});
    EXPECT_TRUE(plan.has_value()) << name << ": " << (plan ? "" : to_string(plan.error().status));
    if (plan) found.push_back({name, plan->path});
  }
  return found;
}

TEST(ParkingTrajectory, StandsAtEveryChangeOfGearAndNowhereElse) {
  std::size_t changes = 0;
  for (const Manoeuvre& manoeuvre : manoeuvres()) {
    SCOPED_TRACE(manoeuvre.name);
    const auto trajectory = Trajectory::along(manoeuvre.path, street().frame());
    ASSERT_TRUE(trajectory);
    double time = 0;
    const auto pieces = trajectory->pieces();
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      time = pieces[i].time;
      const double before = trajectory->segments()[pieces[i - 1].segment].length;
      const double after = trajectory->segments()[pieces[i].segment].length;
      const bool changes_gear = before * after < 0;
      changes += changes_gear ? 1 : 0;
      EXPECT_EQ(std::abs(trajectory->at(time).speed) < 1e-6, changes_gear) << "at " << time << " s";
    }
  }
  EXPECT_GE(changes, 6U) << "the manoeuvres need changes of gear";
}

constexpr double kLookahead = 0.12;  // m; pure pursuit cuts bends by what it looks ahead

OptionValues options_for(const std::string& controller) {
  if (controller == "pure_pursuit") {
    return {{"lookahead", format_number(kLookahead)}, {"lookahead_time", "0.1"}};
  }
  return {};
}

/// By which the heading may be off at the goal, rad: what an arc turns within the tolerance of the position; and
/// pure pursuit steers along the chord to the point that it looks at, so it is behind by half of what the arc turns
/// until there.
double heading_tolerance(const std::string& controller) {
  const double chord = controller == "pure_pursuit" ? kLookahead / 2 : 0;
  return (kTolerance + chord) / kTurnRadius;
}

class FollowParking : public ::testing::TestWithParam<std::tuple<std::string, Drivetrain>> {};

TEST_P(FollowParking, EndsAtTheGoalPoseWithoutACollision) {
  const auto& [name, drivetrain] = GetParam();
  const auto controller = make_controller(name, options_for(name)).value();
  const FreeSpace space = street_for(0);
  double worst = 0;
  double worst_end = 0;
  double worst_heading = 0;
  for (const Manoeuvre& manoeuvre : manoeuvres()) {
    SCOPED_TRACE(manoeuvre.name);
    const Drive drive = simulate(space, manoeuvre.path, *controller, {.drivetrain = drivetrain}, {},
                                 {.goal_tolerance = kTolerance});
    EXPECT_EQ(describe(drive.outcome), describe(DriveOutcome::reached));
    EXPECT_EQ(drive.collisions, 0U);
    std::vector<Pose> driven;
    for (const DriveSample& sample : drive.samples) driven.push_back(sample.pose);
    EXPECT_FALSE(first_collision(Path::through(driven), space));
    worst = std::max(worst, drive.cross_track_largest);
    worst_end = std::max(worst_end, drive.final_error);
    worst_heading = std::max(worst_heading, std::abs(drive.final_heading_error));
  }
  std::cout << name << ", " << choice_name(drivetrain) << ": cross-track error " << worst
            << " m, at the goal " << worst_end << " m and " << worst_heading << " rad at most\n";
  EXPECT_LT(worst, kGrown);
  EXPECT_LT(worst_end, kTolerance);
  EXPECT_LT(worst_heading, heading_tolerance(name));
}

INSTANTIATE_TEST_SUITE_P(Controllers, FollowParking,
                         ::testing::Combine(::testing::Values("pure_pursuit", "stanley"),
                                            ::testing::Values(Drivetrain::differential,
                                                              Drivetrain::bicycle)),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" +
                                  std::string(choice_name(std::get<1>(test.param)));
                         });

}  // namespace
}  // namespace wend::test
