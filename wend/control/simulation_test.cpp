#include "wend/control/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

std::unique_ptr<Controller> driver(std::string_view name, const OptionValues& options = {}) {
  return make_controller(name, options).value();
}

/// Open ground of 10 cells a metre, for a robot of 0.2 m.
FreeSpace open_ground() {
  const Frame frame{.resolution = 0.1, .origin = {-3, 2, 0.5}};
  return *make_free_space(*make_grid_map(Grid<CellState>(120, 120, CellState::free), frame),
                          {.footprint = Footprint::disc(0.2)});
}

/// Ahead to a wall of obstacles, with a gap of `gap` cells in rows 60 and on.
FreeSpace walled(int gap) {
  Grid<CellState> cells(120, 120, CellState::free);
  for (int y = 0; y < 120; ++y) {
    if (y < 60 || y >= 60 + gap) cells[{80, y}] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(cells, {.resolution = 0.1}),
                          {.footprint = Footprint::disc(0.2)});
}

const std::vector<Point> kTour{{20, 20}, {60, 20}, {60, 50}, {30, 60}, {90, 90}};

Path circle(double radius) {
  std::vector<Point> points;
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * kPi * i / 120;
    points.push_back({60 + radius * std::cos(angle), 60 + radius * std::sin(angle)});
  }
  return Path::along(points);
}

/// The robot leaves the path at a turn by no more than the tolerance within which it has arrived there.
TEST(Simulate, TurnsInPlaceWhereThePathDoes) {
  const Path path =
      Path::through({{20, 20, 0},
                     {60, 20, 0},
                     {60, 20, kPi / 2},
                     {60, 60, kPi / 2},
                     {60, 60, -0.8 * kPi},
                     {60 + 40 * std::cos(-0.8 * kPi), 60 + 40 * std::sin(-0.8 * kPi), -0.8 * kPi}});
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    if (name == "p_moving") continue;  // drives while it turns, whatever the path does
    const Drive drive = simulate(open_ground(), path, *driver(name));
    EXPECT_EQ(drive.outcome, DriveOutcome::reached);
    EXPECT_LT(drive.cross_track_largest, 0.12);
  }
}

TEST(Simulate, TellsGainsThatMakeARobotOscillate) {
  const Path path = Path::along(kTour);
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    EXPECT_FALSE(simulate(open_ground(), path, *driver(name)).oscillates());
  }
  for (const char* name : {"p", "p_moving", "pid"}) {
    SCOPED_TRACE(name);
    const auto wild = driver(name, {{"heading_gain", "100"}});
    const Drive drive = simulate(open_ground(), path, *wild);
    EXPECT_TRUE(drive.oscillates()) << drive.swings << " swings in " << drive.time << " s";
  }
}

TEST(Simulate, DrivesToTheGoal) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = driver(name);
    const Path path = Path::along(kTour);
    const Drive drive = simulate(open_ground(), path, *controller);
    EXPECT_EQ(drive.outcome, DriveOutcome::reached);
    EXPECT_LE(drive.final_error, 0.1);
    EXPECT_NEAR(drive.distance, path.length() * 0.1, 0.1 * path.length() * 0.1);
    EXPECT_GE(drive.time, drive.distance / VelocityLimits{}.speed);
    EXPECT_EQ(drive.collisions, 0U);
    EXPECT_EQ(drive.first_collision, std::nullopt);
  }
}

TEST(Simulate, EndsWithItsDeadline) {
  const auto controller = driver("pure_pursuit");
  int looks = 0;
  Limits limits;
  limits.seconds = 10;
  limits.clock = [&looks] { return static_cast<double>(looks++); };
  const Drive drive =
      simulate(open_ground(), Path::along(kTour), *controller, {}, {}, {}, Deadline(limits));
  EXPECT_EQ(drive.outcome, DriveOutcome::time);
  EXPECT_THAT(drive.samples.size(), testing::AllOf(testing::Ge(1U), testing::Le(11U)));
  const std::atomic<bool> cancelled = true;
  limits = {};
  limits.cancel = &cancelled;
  EXPECT_EQ(simulate(open_ground(), Path::along(kTour), *controller, {}, {}, {}, Deadline(limits))
                .samples.size(),
            1U);
}

TEST(Simulate, DrivesStraightOnALine) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = driver(name);
    const Drive drive = simulate(open_ground(), Path::along({{20, 20}, {60, 50}}), *controller);
    EXPECT_EQ(drive.outcome, DriveOutcome::reached);
    EXPECT_LT(drive.turned, 1e-9);
    EXPECT_LT(drive.cross_track_largest, 1e-9);
    EXPECT_LT(std::abs(drive.final_heading_error), 1e-9);
    EXPECT_NEAR(drive.distance + drive.final_error, 5, 1e-9);
  }
}

TEST(Simulate, DrivesALapAroundAClosedCircle) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = driver(name);
    const Drive drive = simulate(open_ground(), circle(30), *controller, {}, {.closed = true});
    EXPECT_EQ(drive.outcome, DriveOutcome::reached);
    EXPECT_NEAR(drive.distance, 2 * kPi * 3, 0.5);
    EXPECT_NEAR(drive.turned, 2 * kPi, 0.7);
    EXPECT_LE(drive.final_error, 0.1);
    EXPECT_LT(drive.cross_track_largest, 0.1);
  }
}

TEST(Simulate, TellsTheSidesOfTheRoute) {
  // One that bears to the left by its own fault drives on the left.
  class Bearing final : public Controller {
   public:
    void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {}
    Velocity command(const ControllerInput&) override { return {0.5, 0.05}; }
  };
  Bearing controller;
  const Drive drive = simulate(open_ground(), Path::along({{20, 60}, {60, 60}}), controller, {}, {},
                               {.off_path = 0.2});
  EXPECT_EQ(drive.outcome, DriveOutcome::off_path);
  EXPECT_GT(drive.samples.back().cross_track, 0.2);
  EXPECT_LT(drive.samples.back().heading_error, 0);
  EXPECT_GT(drive.samples.back().pose.y, 62);
  EXPECT_EQ(drive.cross_track_largest, drive.samples.back().cross_track);
  EXPECT_LT(drive.cross_track_rms, drive.cross_track_largest);
  EXPECT_GT(drive.cross_track_rms, 0);
}

TEST(Simulate, InReverseTheBackLeads) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = driver(name);
    const Path back = Path::through({{90, 60, 0}, {30, 60, 0}});
    const Drive drive = simulate(open_ground(), back, *controller);
    EXPECT_EQ(drive.outcome, DriveOutcome::reached);
    EXPECT_NEAR(drive.final_heading_error, 0, 1e-9);
    for (const DriveSample& sample : drive.samples) {
      EXPECT_LE(sample.velocity.linear, 0);
      EXPECT_NEAR(sample.heading_error, 0, 1e-9);
    }
  }
}

/// Of a path of waypoints, by ternary search on each of its lines.
double distance_to_path(const std::vector<Point>& points, Point point) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto gap = [&](double share) {
      return distance(Line{points[i - 1], points[i]}.at(share), point);
    };
    double low = 0;
    double high = 1;
    for (int halvings = 0; halvings < 100; ++halvings) {
      const double third = (high - low) / 3;
      if (gap(low + third) <= gap(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    nearest = std::min(nearest, gap(low));
  }
  return nearest;
}

TEST(Simulate, SamplesEveryCommand) {
  const auto controller = driver("pure_pursuit");
  const Path path = Path::along(kTour);
  const Drive drive = simulate(open_ground(), path, *controller, {}, {.rate = 10});
  EXPECT_EQ(drive.samples.front().time, 0);
  EXPECT_EQ(drive.samples.front().pose.point(), kTour.front());
  EXPECT_DOUBLE_EQ(drive.samples.back().time, drive.time);
  double largest = 0;
  for (std::size_t i = 0; i < drive.samples.size(); ++i) {
    const DriveSample& sample = drive.samples[i];
    EXPECT_NEAR(sample.time, 0.1 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(std::abs(sample.cross_track), 0.1 * distance_to_path(kTour, sample.pose.point()),
                1e-3);
    largest = std::max(largest, std::abs(sample.cross_track));
  }
  EXPECT_EQ(drive.cross_track_largest, largest);
}

RC_GTEST_PROP(Simulate, NeverExceedsTheLimits, (std::uint64_t seed)) {
  Random random(seed);
  MotionModel model;
  const auto name = controllers().names()[random.below(4)];
  if (name == "pure_pursuit" && random.chance(0.5)) model.drivetrain = Drivetrain::bicycle;
  model.limits = {.speed = 0.1 + random.uniform(),
                  .turn_rate = 0.2 + 2 * random.uniform(),
                  .acceleration = 0.2 + 2 * random.uniform(),
                  .turn_acceleration = 0.5 + 5 * random.uniform()};
  SimulationOptions options{.rate = 5 + 45 * random.uniform()};
  if (random.chance(0.5)) options.latency = 0.3 * random.uniform();
  if (random.chance(0.5)) options.position_noise = 0.02;
  std::vector<Point> points{{60, 60}};
  for (int i = 0; i < 4; ++i)
    points.push_back({20 + 80 * random.uniform(), 20 + 80 * random.uniform()});
  const auto controller = driver(name);
  const Drive drive = simulate(open_ground(), Path::along(points), *controller, model, options);
  // Within a period commands change once where there is latency.
  const double period = 1 / options.rate;
  constexpr double kTolerated = 1e-9;
  for (std::size_t i = 1; i < drive.samples.size(); ++i) {
    const Velocity& before = drive.samples[i - 1].velocity;
    const Velocity& now = drive.samples[i].velocity;
    RC_ASSERT(std::abs(now.linear) <= model.limits.speed + kTolerated);
    RC_ASSERT(std::abs(now.angular) <= model.limits.turn_rate + kTolerated);
    RC_ASSERT(std::abs(now.linear - before.linear) <=
              model.limits.acceleration * period + kTolerated);
    RC_ASSERT(std::abs(now.angular - before.angular) <=
              model.limits.turn_acceleration * period + kTolerated);
    if (const double radius = model.turning_radius(); radius > 0) {
      RC_ASSERT(std::abs(now.angular) * radius <= std::abs(now.linear) + kTolerated);
    }
  }
}

TEST(Simulate, EndsAtTheFirstCollision) {
  const auto controller = driver("p");
  const Drive drive = simulate(walled(0), Path::along({{40, 60}, {110, 60}}), *controller);
  EXPECT_EQ(drive.outcome, DriveOutcome::collision);
  EXPECT_EQ(drive.collisions, 1U);
  ASSERT_TRUE(drive.first_collision);
  EXPECT_NEAR(drive.first_collision->x, 78, 1e-6) << "the disc of 2 cells touches column 80";
  EXPECT_NEAR(drive.first_collision->y, 60, 1e-6);
  EXPECT_NEAR(drive.samples.back().pose.x, 78, 1e-6) << "it stands there";
  EXPECT_NEAR(drive.distance, 3.8, 1e-6);
  EXPECT_NEAR(drive.samples.back().time, drive.time, 1e-12);
}

TEST(Simulate, PassesAGapThatIsWideEnough) {
  const auto controller = driver("p");
  const Path path = Path::along({{40, 62}, {110, 62}});
  EXPECT_EQ(simulate(walled(4), path, *controller).outcome, DriveOutcome::reached);
  EXPECT_EQ(simulate(walled(3), path, *controller).outcome, DriveOutcome::collision);
}

TEST(Simulate, CountsCollisionsWhereItDrivesOn) {
  Grid<CellState> cells(120, 120, CellState::free);
  for (const int x : {50, 70, 73, 90}) cells[{x, 61}] = CellState::occupied;
  const FreeSpace space = *make_free_space(*make_grid_map(cells, {.resolution = 0.1}),
                                           {.footprint = Footprint::disc(0.2)});
  const auto controller = driver("pure_pursuit");
  const Drive drive = simulate(space, Path::along({{30, 60}, {110, 60}}), *controller, {},
                               {.stop_at_collision = false});
  EXPECT_EQ(drive.outcome, DriveOutcome::reached);
  EXPECT_EQ(drive.collisions, 3U) << "it did not come free between the two in the middle";
  EXPECT_NEAR(drive.first_collision->x, 50 - std::sqrt(3), 1e-6);
}

TEST(Simulate, OfARobotThatStandsInAnObstacleEndsAtOnce) {
  const auto controller = driver("p_moving");
  const Drive drive = simulate(walled(0), Path::along({{80.5, 60}, {110, 60}}), *controller);
  EXPECT_EQ(drive.outcome, DriveOutcome::collision);
  EXPECT_EQ(drive.time, 0);
  EXPECT_EQ(drive.distance, 0);
  EXPECT_EQ(drive.first_collision, (Point{80.5, 60}));
}

bool same(const Drive& a, const Drive& b) {
  return a.time == b.time && a.distance == b.distance && a.samples.size() == b.samples.size() &&
         std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(),
                    [](const DriveSample& one, const DriveSample& other) {
                      return one.pose == other.pose && one.velocity == other.velocity;
                    });
}

TEST(Simulate, HasNoiseFromItsSeed) {
  for (const SimulationOptions& noise :
       {SimulationOptions{.actuation_noise = 0.1}, SimulationOptions{.position_noise = 0.02},
        SimulationOptions{.heading_noise = 0.02}}) {
    for (const std::string& name : controllers().names()) {
      SCOPED_TRACE(name);
      const auto controller = driver(name);
      const Path path = Path::along(kTour);
      SimulationOptions options = noise;
      const Drive drive = simulate(open_ground(), path, *controller, {}, options);
      EXPECT_EQ(drive.outcome, DriveOutcome::reached);
      EXPECT_TRUE(same(simulate(open_ground(), path, *controller, {}, options), drive));
      options.seed = 2;
      EXPECT_FALSE(same(simulate(open_ground(), path, *controller, {}, options), drive));
      EXPECT_FALSE(same(simulate(open_ground(), path, *controller), drive));
    }
  }
}

TEST(Simulate, ScattersVelocitiesAsMuchAsTold) {
  const auto controller = driver("pure_pursuit");
  const Drive drive = simulate(open_ground(), Path::along({{10, 60}, {110, 60}}), *controller, {},
                               {.rate = 200, .actuation_noise = 0.2});
  double sum = 0;
  double squares = 0;
  int count = 0;
  for (const DriveSample& sample : drive.samples) {
    if (sample.time < 1 || sample.time > 15) continue;  // at full speed
    const double error = sample.velocity.linear / VelocityLimits{}.speed - 1;
    sum += error;
    squares += error * error;
    ++count;
  }
  EXPECT_NEAR(sum / count, 0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / count), 0.2, 0.02);
}

TEST(Simulate, CommandsTakeEffectAfterTheLatency) {
  class Starting final : public Controller {
   public:
    void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {}
    Velocity command(const ControllerInput&) override { return {0.5, 0}; }
  };
  Starting controller;
  const MotionModel model{.limits = {.speed = 0.5, .acceleration = 1e6}};
  for (const double latency : {0.0, 0.05, 0.1, 0.3, 0.07, 0.22}) {
    SCOPED_TRACE(latency);
    const Drive drive = simulate(open_ground(), Path::along({{20, 60}, {60, 60}}), controller,
                                 model, {.rate = 20, .latency = latency});
    EXPECT_EQ(drive.outcome, DriveOutcome::reached);
    for (const DriveSample& sample : drive.samples) {
      if (sample.time > 2) break;
      const double driven = 0.5 * std::max(sample.time - latency, 0.0);
      EXPECT_NEAR((sample.pose.x - 20) * 0.1, driven, 1e-9) << "at " << sample.time << " s";
    }
    EXPECT_EQ(drive.samples.back().velocity, Velocity{}) << "it stands at the end";
  }
}

TEST(Simulate, TellsWrongGains) {
  const Path path = Path::along(kTour);
  const auto outcome = [&](std::string_view name, const OptionValues& gains,
                           const SimulationOptions& options = {}) {
    return simulate(open_ground(), path, *driver(name, gains), {}, options).outcome;
  };
  EXPECT_EQ(outcome("p", {{"heading_gain", "0"}}), DriveOutcome::stuck) << "it never turns";
  EXPECT_EQ(outcome("p", {{"distance_gain", "0"}}), DriveOutcome::stuck) << "it never drives";
  EXPECT_EQ(outcome("p", {{"heading_gain", "100"}, {"turn_above", "0.01"}, {"drive_below", "0.01"}},
                    {.latency = 0.5}),
            DriveOutcome::stuck)
      << "it turns to and fro";
  EXPECT_EQ(outcome("p_moving", {{"heading_gain", "0"}, {"standing_angle", "1000"}}),
            DriveOutcome::off_path)
      << "it drives straight on";
  EXPECT_EQ(outcome("pid", {{"heading_gain", "0"}, {"heading_integral", "50"}}),
            DriveOutcome::stuck)
      << "it swings ever wider";
  EXPECT_EQ(outcome("pure_pursuit", {{"lookahead", "10"}}), DriveOutcome::off_path)
      << "it cuts corners";
  EXPECT_EQ(outcome("p_moving", {}, {.time_limit = 5}), DriveOutcome::time);
}

RC_GTEST_PROP(Simulate, EndsWhateverTheGains, (std::uint64_t seed)) {
  Random random(seed);
  for (const ControllerInfo& info : controllers()) {
    OptionValues gains;
    for (const OptionInfo& option : info.options) {
      const double share = random.uniform();
      const double log_least = std::log(std::max(option.least, 1e-3));
      const double value = std::exp(log_least + share * (std::log(option.greatest) - log_least));
      gains.emplace_back(option.name,
                         std::to_string(std::clamp(value, option.least, option.greatest)));
    }
    const auto controller = info.make(gains);
    RC_ASSERT(controller.has_value());
    SimulationOptions options{.rate = 10};
    options.latency = random.chance(0.5) ? random.uniform() : 0;
    options.actuation_noise = random.chance(0.5) ? random.uniform() : 0;
    options.heading_noise = random.chance(0.5) ? random.uniform() : 0;
    const Drive drive = simulate(open_ground(), Path::along(kTour), **controller, {}, options);
    const double limit = 60 + 10 * Path::along(kTour).length() * 0.1 / VelocityLimits{}.speed;
    RC_ASSERT(drive.time <= limit + 1);
    RC_ASSERT(std::isfinite(drive.cross_track_rms));
    RC_ASSERT((drive.outcome == DriveOutcome::reached) <= (drive.final_error < 1));
  }
}

TEST(Simulate, AControllerThatTurnsInPlaceGetsABicycleStuck) {
  const auto controller = driver("p");
  const Drive drive =
      simulate(open_ground(), Path::along(kTour), *controller, {.drivetrain = Drivetrain::bicycle});
  EXPECT_EQ(drive.outcome, DriveOutcome::stuck);
}

TEST(Simulate, StandsWhereAPathOfOnePointIs) {
  const auto controller = driver("pid");
  const Drive drive = simulate(open_ground(), Path({{5, 5}}), *controller);
  EXPECT_EQ(drive.outcome, DriveOutcome::reached);
  EXPECT_EQ(drive.time, 0);
  EXPECT_EQ(drive.samples.size(), 1U);
}

/// "Reached" by the test's own reckoning.
void expect_reached_is_true(const Drive& drive, const MapPose& goal, const FollowerOptions& asked) {
  if (drive.outcome != DriveOutcome::reached) return;
  const DriveSample& last = drive.samples.back();
  EXPECT_EQ(last.velocity, Velocity{});
  const MapPose stands = open_ground().map().frame().to_metres(last.pose);
  EXPECT_LE(std::hypot(stands.x - goal.x, stands.y - goal.y), asked.goal_tolerance);
  const double turned = std::remainder(stands.heading - goal.heading, 2 * kPi);
  EXPECT_LE(std::abs(turned), asked.heading_tolerance);
}

TEST(Simulate, ReachedMeansThatTheRobotStandsWithinTheTolerances) {
  const Path path = Path::through({{20, 20, 0}, {60, 20, 0}, {60, 20, 2}});
  const MapPose goal = open_ground().map().frame().to_metres(path.poses().back());
  for (const std::string& name : controllers().names()) {
    for (const double latency : {0.0, 0.1, 0.3}) {
      for (const double tolerance : {0.02, 0.05, 0.2}) {
        for (const double noise : {0.0, 0.01}) {
          SCOPED_TRACE(name + " " + std::to_string(latency) + " " + std::to_string(tolerance));
          const FollowerOptions asked{.goal_tolerance = tolerance};
          const Drive drive =
              simulate(open_ground(), path, *driver(name), {.limits = {.speed = 1.5}},
                       {.position_noise = noise, .latency = latency}, asked);
          if (noise == 0) {
            EXPECT_EQ(drive.outcome, DriveOutcome::reached);
          }
          expect_reached_is_true(drive, goal, asked);
        }
      }
    }
  }
}

TEST(Simulate, RefusesWhatCannotBeDriven) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto controller = driver("stanley");
  const auto refusal = [&](const Path& path, const MotionModel& model = {},
                           const SimulationOptions& options = {},
                           const FollowerOptions& follower = {}) {
    const Drive drive = simulate(open_ground(), path, *controller, model, options, follower);
    EXPECT_EQ(drive.outcome, DriveOutcome::refused);
    EXPECT_TRUE(drive.samples.empty());
    return drive.refusal;
  };
  const Path good = Path::through({{20, 20, 0}, {60, 20, 0}});
  EXPECT_EQ(refusal(Path()), "the path is empty");
  for (const double number : {kNan, std::numeric_limits<double>::infinity(), 1e300}) {
    EXPECT_EQ(
        refusal(Path::along({{20, 20}, {number, 20}})),
        "the path has a number that is not finite, is farther than 1e+08 m from the origin, or has "
        "a heading beyond 1e+06 rad");
    EXPECT_EQ(refusal(good, {.limits = {.speed = number}}), "speed must be from 0.001 to 1000");
    EXPECT_EQ(refusal(good, {}, {.latency = number}), "latency must be from 0 to 10");
    EXPECT_EQ(refusal(good, {}, {.rate = number}), "rate must be from 0.1 to 10000");
    EXPECT_EQ(refusal(good, {}, {}, {.goal_tolerance = number}),
              "goal_tolerance must be from 0.001 to 1000");
  }
  EXPECT_EQ(refusal(Path::through({{20, 20, 0}, {20, 60, 0}})),
            "the path steps to a side of the robot at (-2.2,4.71) m, which a robot on wheels "
            "cannot drive");
  const MotionModel bicycle{.drivetrain = Drivetrain::bicycle};
  EXPECT_THAT(refusal(Path::through({{20, 20, 0}, {60, 20, 0}, {60, 20, 0.1}}), bicycle),
              testing::HasSubstr("turns in place at"));
  EXPECT_THAT(refusal(Path::through({{20, 20, 0}, {22, 22, kPi / 2}}), bicycle),
              testing::HasSubstr("tighter than the bicycle can steer, whose radius is 0.44 m"));
}

TEST(Simulate, DescribesOutcomes) {
  EXPECT_EQ(describe(DriveOutcome::reached), "reached the goal");
  EXPECT_EQ(describe(DriveOutcome::stuck), "got stuck");
  EXPECT_EQ(describe(DriveOutcome::off_path), "left the path");
  EXPECT_EQ(describe(DriveOutcome::collision), "ran into an obstacle");
  EXPECT_EQ(describe(DriveOutcome::time), "ran out of time");
  EXPECT_EQ(describe(DriveOutcome::missed), "stopped beside the goal");
  EXPECT_EQ(describe(DriveOutcome::refused), "was refused");
}

}  // namespace
}  // namespace wend
