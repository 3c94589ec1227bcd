#include "wend/control/follower.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kPeriod = 0.05;  // s

Route route_through(const std::vector<Point>& points, bool closed = false) {
  return Route(Path::along(points), {}, closed);
}

/// A controller that always wants the same, and remembers what it was shown.
class Stubborn final : public Controller {
 public:
  explicit Stubborn(const Velocity& wanted) : wanted_(wanted) {}
  void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override { ++begun; }
  Velocity command(const ControllerInput& input) override {
    shown = input;
    return wanted_;
  }

  ControllerInput shown;
  int begun = 0;

 private:
  Velocity wanted_;
};

/// A robot that does as it is told, and its follower.
struct TestRobot {
  Follower follower;
  MotionModel model{};
  RobotState state{};
  double time = 0;

  FollowerStep step() {
    const FollowerStep step = follower.step(state.pose, kPeriod);
    state = drive(model, state, step.command, kPeriod).to;
    time += kPeriod;
    return step;
  }

  /// Until it drives no more.
  FollowerState run() {
    constexpr double kForever = 1e4;
    while (time < kForever) {
      if (const FollowerState now = step().state; now != FollowerState::driving) return now;
    }
    ADD_FAILURE() << "it hangs";
    return FollowerState::driving;
  }
};

std::unique_ptr<Controller> made_controller(std::string_view name,
                                            const OptionValues& options = {}) {
  return make_controller(name, options).value();
}

TEST(Follower, HasNothingToDoBeforeItFollows) {
  Stubborn controller({1, 0});
  Follower follower(controller);
  const FollowerStep step = follower.step({0, 0, 0}, kPeriod);
  EXPECT_EQ(step.state, FollowerState::reached);
  EXPECT_EQ(step.command, Velocity{});
}

TEST(Follower, KeepsToLimitsThatChangeOnTheWay) {
  const auto controller = made_controller("pure_pursuit");
  TestRobot robot{.follower = Follower(*controller), .model = {.limits = {.speed = 1}}};
  robot.follower.follow(route_through({{0, 0}, {20, 0}}));
  while (robot.state.pose.x < 5) robot.step();
  EXPECT_NEAR(robot.state.velocity.linear, 0.5, 1e-9);
  robot.follower.set_limits({.speed = 0.2});
  const double along = robot.follower.along();
  for (int i = 0; i < 10; ++i) robot.step();
  EXPECT_GT(robot.follower.along(), along);
  while (robot.state.pose.x < 10) {
    robot.step();
    ASSERT_LE(robot.state.velocity.linear, 0.2 + 1e-9);
  }
  robot.follower.set_limits({.speed = 0.4});
  EXPECT_EQ(robot.follower.limits().speed, 0.4);
  while (robot.state.pose.x < 15) robot.step();
  EXPECT_NEAR(robot.state.velocity.linear, 0.4, 1e-9);
  EXPECT_EQ(robot.run(), FollowerState::reached);
}

TEST(Follower, CommandsWhatARobotOfAnotherVelocityCanReach) {
  Stubborn controller({0.5, 0});
  Follower follower(controller, {.speed = 0.5, .acceleration = 1});
  follower.follow(route_through({{0, 0}, {20, 0}}));
  EXPECT_NEAR(follower.step({0, 0, 0}, kPeriod).command.linear, 0.05, 1e-9);
  follower.set_velocity({0.3, 0});
  EXPECT_NEAR(follower.step({0.01, 0, 0}, kPeriod).command.linear, 0.35, 1e-9);
  follower.set_velocity({});
  EXPECT_NEAR(follower.step({0.02, 0, 0}, kPeriod).command.linear, 0.05, 1e-9);
}

TEST(Follower, ArrivesWithEveryController) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    TestRobot robot{Follower(*controller)};
    robot.follower.follow(route_through({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
    EXPECT_EQ(robot.run(), FollowerState::reached);
    EXPECT_LE(distance(robot.state.pose.point(), {0, 2}), 0.1);
    EXPECT_EQ(robot.state.velocity, Velocity{}) << "it stands";
    EXPECT_EQ(robot.step().state, FollowerState::reached) << "and stays so";
  }
}

TEST(Follower, KeepsTheLimits) {
  Stubborn controller({9, 9});
  const VelocityLimits limits{
      .speed = 0.5, .turn_rate = 1, .acceleration = 1, .turn_acceleration = 2};
  Follower follower(controller, limits, {.off_path = 100});
  follower.follow(route_through({{0, 0}, {90, 0}}));
  EXPECT_EQ(follower.step({0, 0, 0}, 0.125).command, (Velocity{0.125, 0.25}));
  EXPECT_EQ(controller.shown.velocity, Velocity{});
  EXPECT_EQ(follower.step({0, 0, 0}, 0.125).command, (Velocity{0.25, 0.5}));
  EXPECT_EQ(controller.shown.velocity, (Velocity{0.125, 0.25}));
  for (int i = 0; i < 10; ++i) follower.step({0, 0, 0}, 0.125);
  EXPECT_EQ(follower.step({0, 0, 0}, 0.125).command, (Velocity{0.5, 1}));
}

TEST(Follower, TellsErrorsAtTheRoute) {
  Stubborn controller({0, 0});
  Follower follower(controller);
  follower.follow(route_through({{0, 0}, {9, 0}}));
  const FollowerStep step = follower.step({0.5, -0.25, 0.1}, kPeriod);
  EXPECT_EQ(step.cross_track, 0.25);
  EXPECT_NEAR(step.heading_error, -0.1, 1e-12);
  EXPECT_EQ(follower.along(), 0.5);
}

TEST(Follower, NeverGoesBack) {
  Stubborn controller({0, 0});
  Follower follower(controller);
  follower.follow(route_through({{0, 0}, {9, 0}}));
  follower.step({0.8, 0, 0}, kPeriod);
  follower.step({0.3, 0, 0}, kPeriod);
  EXPECT_EQ(follower.along(), 0.8);
}

TEST(Follower, SkipsWaypointsThatAreBehindOrNear) {
  Stubborn controller({0, 0});
  Follower follower(controller, {}, {.acceptance_radius = 0.25});
  follower.follow(route_through({{0, 0}, {0.5, 0}, {1, 0}, {1.5, 0}, {2, 0}}));
  const auto next_at = [&](double x) {
    follower.step({x, 0, 0}, kPeriod);
    return controller.shown.waypoint;
  };
  EXPECT_EQ(next_at(0), 1U);
  EXPECT_EQ(next_at(0.2), 1U);
  EXPECT_EQ(next_at(0.3), 2U) << "near enough";
  EXPECT_EQ(next_at(1.1), 3U) << "behind";
  EXPECT_EQ(next_at(0.6), 3U) << "never back";
  EXPECT_EQ(next_at(1.85), 4U);
}

TEST(Follower, GoesOnFromTheNearestPointOfANewRoute) {
  Stubborn controller({0.5, 0});
  Follower follower(controller);
  follower.follow(route_through({{0, 0}, {9, 0}}));
  for (int i = 0; i < 20; ++i) follower.step({0.4, 0, 0}, kPeriod);
  follower.follow(route_through({{0, 0.25}, {9, 0.25}}));
  EXPECT_EQ(controller.begun, 2);
  const FollowerStep step = follower.step({0.5, 0, 0}, kPeriod);
  EXPECT_EQ(follower.along(), 0.5);
  EXPECT_EQ(step.command.linear, 0.5) << "without slowing down";
}

TEST(Follower, ThereAndBackDrivesBothWays) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    TestRobot robot{Follower(*controller)};
    robot.follower.follow(route_through({{0, 0}, {3, 0}, {0, 0}}));
    double farthest = 0;
    while (robot.step().state == FollowerState::driving) {
      farthest = std::max(farthest, robot.state.pose.x);
    }
    EXPECT_GT(farthest, 3 - 0.2);
    EXPECT_LE(distance(robot.state.pose.point(), {0, 0}), 0.1);
    EXPECT_GE(robot.follower.along(), 6 - 0.2);
  }
}

TEST(Follower, DrivesAFigureOfEightWithoutLeavingOutALoop) {
  std::vector<Point> eight;
  for (int i = 0; i <= 200; ++i) {
    const double t = 2 * kPi * i / 200;
    eight.push_back({1.5 * std::sin(t), 0.75 * std::sin(2 * t)});
  }
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    TestRobot robot{Follower(*controller)};
    const Route route = route_through(eight);
    robot.state.pose = route.start();
    robot.follower.follow(route);
    double driven = 0;
    while (robot.step().state == FollowerState::driving) {
      driven += std::abs(robot.state.velocity.linear) * kPeriod;
    }
    EXPECT_EQ(robot.step().state, FollowerState::reached);
    EXPECT_NEAR(driven, route.length(), 0.1 * route.length());
  }
}

TEST(Follower, DrivesALapOfAClosedRoute) {
  std::vector<Point> circle;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * kPi * i / 100;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    TestRobot robot{Follower(*controller)};
    const Route lap = route_through(circle, true);
    robot.state.pose = lap.start();
    robot.follower.follow(lap);
    double driven = 0;
    while (robot.step().state == FollowerState::driving) {
      driven += std::abs(robot.state.velocity.linear) * kPeriod;
    }
    EXPECT_EQ(robot.step().state, FollowerState::reached);
    EXPECT_NEAR(driven, 2 * kPi, 0.3);
  }
}

Route forth_and_back() {
  return Route(Path::through({{0, 0, 0}, {2, 0, 0}, {1, 1, -kPi / 2}, {1, 3, -kPi / 2}}), {});
}

TEST(Follower, ShowsARobotInReverseAsIfItFacedBackwards) {
  Stubborn controller({0.5, 0.25});
  Follower follower(controller, {.acceleration = 1e6, .turn_acceleration = 1e6});
  follower.follow(Route(Path::through({{2, 0, 0}, {0, 0, 0}}), {}));
  const FollowerStep step = follower.step({1.5, 0, 0.125}, kPeriod);
  EXPECT_NEAR(controller.shown.pose.heading, 0.125 - kPi, 1e-12);
  EXPECT_EQ(step.command, (Velocity{-0.5, 0.25}));
  EXPECT_NEAR(step.heading_error, -0.125, 1e-12);
  follower.step({1.4, 0, 0.125}, kPeriod);
  EXPECT_EQ(controller.shown.velocity, (Velocity{0.5, 0.25}));
}

TEST(Follower, DrivesLegsInReverse) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    TestRobot robot{Follower(*controller)};
    const Route route = forth_and_back();
    robot.follower.follow(route);
    bool was_in_reverse = false;
    while (robot.step().state == FollowerState::driving) {
      was_in_reverse = was_in_reverse || robot.state.velocity.linear < -0.1;
    }
    EXPECT_EQ(robot.step().state, FollowerState::reached);
    EXPECT_TRUE(was_in_reverse);
    EXPECT_LE(distance(robot.state.pose.point(), {1, 3}), 0.1);
    EXPECT_NEAR(robot.state.pose.heading, -kPi / 2, 0.1);
    EXPECT_NEAR(robot.follower.along(), route.length(), 0.1);
  }
}

TEST(Follower, TurnsToTheGoalsHeading) {
  for (const double heading : {0.0, kPi / 2, kPi, -kPi / 2}) {
    SCOPED_TRACE(heading);
    const auto controller = made_controller("p_moving");
    TestRobot robot{Follower(*controller, {}, {.heading_tolerance = 0.05})};
    // The last pose's arc has no length to speak of, but a heading.
    robot.follower.follow(Route(Path::through({{0, 0, 0}, {2, 0, 0}, {2, 0, heading}}), {}));
    EXPECT_EQ(robot.run(), FollowerState::reached);
    EXPECT_NEAR(normalized_angle(robot.state.pose.heading - heading), 0, 0.05);
    EXPECT_EQ(robot.state.velocity, Velocity{});
  }
}

TEST(Follower, TellsARobotThatCannotTurnToTheGoalsHeading) {
  const auto controller = made_controller("pure_pursuit");
  TestRobot robot{Follower(*controller, {}, {.heading_tolerance = 0.05, .turns_in_place = false})};
  robot.follower.follow(Route(Path::through({{0, 0, 0}, {2, 0, 0}, {2, 0, 1}}), {}));
  EXPECT_EQ(robot.run(), FollowerState::stuck);
  EXPECT_LE(distance(robot.state.pose.point(), {2, 0}), 0.1);
}

TEST(Follower, TellsThatItLeftThePath) {
  Stubborn controller({0.5, 0.1});
  TestRobot robot{Follower(controller, {}, {.off_path = 0.5})};
  robot.follower.follow(route_through({{0, 0}, {90, 0}}));
  EXPECT_EQ(robot.run(), FollowerState::off_path);
  EXPECT_GT(robot.state.pose.y, 0.45);
  for (int i = 0; i < 20; ++i) robot.step();
  EXPECT_EQ(robot.state.velocity, Velocity{}) << "it has braked";
}

TEST(Follower, TellsThatItIsStuck) {
  const std::array<Velocity, 4> stubborn{{{0, 0}, {0.5, 1.5}, {0, 1.5}, {-0.01, 0}}};
  for (const Velocity& wanted : stubborn) {
    for (const double heading : {0.0, kPi / 2, kPi}) {
      SCOPED_TRACE(std::to_string(wanted.linear) + " " + std::to_string(wanted.angular));
      Stubborn controller(wanted);  // stands, circles, turns on the spot, creeps back
      TestRobot robot{Follower(controller, {}, {.stuck_time = 3})};
      robot.state.pose.heading = heading;
      robot.follower.follow(route_through({{0, 0}, {90, 0}}));
      EXPECT_EQ(robot.run(), FollowerState::stuck);
      EXPECT_LT(robot.time, 20);
    }
  }
}

TEST(Follower, TellsAControllerThatOscillates) {
  class Oscillating final : public Controller {
   public:
    void begin(const MapPolyline& /*line*/, const VelocityLimits& /*limits*/) override {}
    Velocity command(const ControllerInput&) override {
      return {0, ++count_ / 20 % 2 == 0 ? 1.5 : -1.5};
    }

   private:
    int count_ = 0;
  };
  Oscillating controller;
  TestRobot robot{Follower(controller, {}, {.stuck_time = 3})};
  robot.follower.follow(route_through({{0, 0}, {90, 0}}));
  EXPECT_EQ(robot.run(), FollowerState::stuck);
}

TEST(Follower, IsNotStuckBecauseTheRobotIsSlow) {
  const auto controller = made_controller("p");
  const MotionModel snail{.limits = {.speed = 1e-3, .turn_rate = 0.01}};
  TestRobot robot{Follower(*controller, snail.limits, {.goal_tolerance = 0.01}), snail};
  robot.state.pose = {0, 0, 1};
  robot.follower.follow(route_through({{0, 0}, {0.2, 0}}));
  EXPECT_EQ(robot.run(), FollowerState::reached);
}

TEST(Follower, BrakesWhileThePoseIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const MapPose& pose : {MapPose{kNan, 0, 0}, MapPose{0, kNan, 0}, MapPose{0, 0, kNan},
                              MapPose{kInfinite, 0, 0}, MapPose{0, 0, -kInfinite}}) {
    Stubborn controller({0.5, 0});
    Follower follower(controller, {}, {.stuck_time = 3});
    follower.follow(route_through({{0, 0}, {90, 0}}));
    for (int i = 0; i < 20; ++i) follower.step({0, 0, 0}, kPeriod);
    EXPECT_EQ(follower.step({0, 0, 0}, kPeriod).command.linear, 0.5);
    const FollowerStep lost = follower.step(pose, kPeriod);
    EXPECT_EQ(lost.state, FollowerState::driving);
    EXPECT_LT(lost.command.linear, 0.5);
    EXPECT_EQ(follower.step({0.1, 0, 0}, kPeriod).command.linear, 0.5) << "and goes on";
    FollowerState state = FollowerState::driving;
    for (int i = 0; i < 70; ++i) state = follower.step(pose, kPeriod).state;
    EXPECT_EQ(state, FollowerState::stuck);
  }
}

TEST(Follower, CallsAPoseThatIsFarAwayOffThePath) {
  for (const double far : {1e3, 1e100, 1e300}) {
    Stubborn controller({0.5, 0});
    Follower follower(controller);
    follower.follow(route_through({{0, 0}, {90, 0}}));
    const FollowerStep step = follower.step({far, -far, far}, kPeriod);
    EXPECT_EQ(step.state, FollowerState::off_path);
    EXPECT_EQ(step.command, Velocity{});
  }
}

TEST(Follower, BrakesInTimeForTheGoal) {
  Stubborn controller({9, 0});
  const MotionModel fast{.limits = {.speed = 5, .acceleration = 1}};
  TestRobot robot{Follower(controller, fast.limits), fast};
  robot.follower.follow(route_through({{0, 0}, {30, 0}}));
  EXPECT_EQ(robot.run(), FollowerState::reached);
  EXPECT_NEAR(robot.state.pose.x, 30, 0.1);
}

/// Drives from there to the end, and says how far it came.
double driven_by(TestRobot& robot) {
  double driven = 0;
  while (robot.step().state == FollowerState::driving) {
    driven += std::abs(robot.state.velocity.linear) * kPeriod;
  }
  return driven;
}

TEST(Follower, JoinsARouteInItsMiddle) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    TestRobot robot{Follower(*controller)};
    robot.state.pose = {6, 0.05, 0};
    robot.follower.follow(route_through({{0, 0}, {10, 0}}));
    EXPECT_NEAR(driven_by(robot), 4, 0.2);
    EXPECT_EQ(robot.step().state, FollowerState::reached);

    TestRobot parking{Follower(*controller)};
    parking.state.pose = {1, 1.5, -kPi / 2};
    const Route route = forth_and_back();
    parking.follower.follow(route);
    EXPECT_NEAR(driven_by(parking), 1.5, 0.2);
    EXPECT_EQ(parking.step().state, FollowerState::reached);
    EXPECT_NEAR(parking.follower.along(), route.length(), 0.1);
  }
}

TEST(Follower, JoinsWhereItCanReachTheRoute) {
  Stubborn controller({0.5, 0});
  Follower follower(controller);
  const FreeLine below = [](const MapPose&, MapPoint to) { return to.y < 0.3; };
  follower.follow(route_through({{0, 0.5}, {0, 0}, {9, 0}, {9, 0.5}, {0, 0.5}}), below);
  follower.step({4, 0.4, 0}, kPeriod);
  EXPECT_NEAR(follower.along(), 4.5, 1e-9);
}

TEST(Follower, TheSameRouteAgainChangesNothing) {
  Stubborn controller({0.5, 0});
  TestRobot robot{Follower(controller)};
  const Route route = route_through({{0, 0}, {3, 0}, {0, 0}});
  robot.follower.follow(route);
  for (int i = 0; i < 60; ++i) robot.step();
  const int begun = controller.begun;
  const double along = robot.follower.along();
  const Velocity velocity = robot.state.velocity;
  robot.follower.follow(route);
  robot.step();
  EXPECT_EQ(controller.begun, begun);
  EXPECT_GT(robot.follower.along(), along);
  EXPECT_EQ(robot.state.velocity, velocity);
}

TEST(Follower, IsStuckThoughPathsComeAgain) {
  for (const double shift : {0.0, 0.01}) {
    Stubborn controller({0, 0});
    Follower follower(controller, {}, {.stuck_time = 3});
    FollowerState state = FollowerState::driving;
    double time = 0;
    for (; state == FollowerState::driving && time < 20; time += kPeriod) {
      const int second = static_cast<int>(time);
      follower.follow(route_through({{0, 0}, {9, shift * second}}));
      state = follower.step({0, 0, 0}, kPeriod).state;
    }
    EXPECT_EQ(state, FollowerState::stuck);
    EXPECT_NEAR(time, 3, 0.3);
  }
}

TEST(Follower, TurnsToTheHeadingOfTheGoalByDefault) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    for (const double heading : {0.3, 2.0, -3.0}) {
      const auto controller = made_controller(name);
      TestRobot robot{Follower(*controller)};
      robot.follower.follow(Route(Path::through({{0, 0, 0}, {2, 0, 0}, {2, 0, heading}}), {}));
      EXPECT_EQ(robot.run(), FollowerState::reached);
      EXPECT_NEAR(normalized_angle(robot.state.pose.heading - heading), 0, 0.1);
      TestRobot any{Follower(*controller, {}, {.heading_tolerance = 0})};
      any.follower.follow(Route(Path::through({{0, 0, 0}, {2, 0, 0}, {2, 0, heading}}), {}));
      EXPECT_EQ(any.run(), FollowerState::reached);
      EXPECT_NEAR(any.state.pose.heading, 0, 0.1) << "any heading";
    }
  }
}

TEST(Follower, DrivesToASinglePoseAtItsSpeed) {
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    for (const double heading : {0.0, 1.0, kPi}) {
      const auto controller = made_controller(name);
      TestRobot robot{Follower(*controller)};
      robot.state.pose = {0, 0, heading};
      robot.follower.follow(Route(Path::through({{0.6, 0, 0}, {0.6, 0, 0}}), {}));
      EXPECT_EQ(robot.run(), FollowerState::reached);
      EXPECT_LE(distance(robot.state.pose.point(), {0.6, 0}), 0.1);
      EXPECT_NEAR(normalized_angle(robot.state.pose.heading), 0, 0.1);
      EXPECT_LT(robot.time, 8);
    }
  }
}

/// Commands reach the wheels late: it passes the end, and comes back.
TEST(Follower, ComesBackToAnEndThatItHasPassed) {
  for (const std::string& name : controllers().names()) {
    for (const bool reverse : {false, true}) {
      SCOPED_TRACE(name + (reverse ? " in reverse" : ""));
      const auto controller = made_controller(name);
      const VelocityLimits fast{.speed = 2};
      Follower follower(*controller, fast, {.goal_tolerance = 0.05});
      const std::vector<Pose> ahead{{0, 0, 0}, {6, 0, 0}};
      follower.follow(
          Route(Path::through(reverse ? std::vector<Pose>{{6, 0, 0}, {0, 0, 0}} : ahead), {}));
      RobotState state{{reverse ? 6.0 : 0.0, 0, 0}};
      std::vector<Velocity> on_the_way(6);
      FollowerState now = FollowerState::driving;
      for (int i = 0; i < 4000 && now == FollowerState::driving; ++i) {
        const FollowerStep step = follower.step(state.pose, kPeriod);
        now = step.state;
        on_the_way.push_back(step.command);
        state = drive({.limits = fast}, state, on_the_way.front(), kPeriod).to;
        on_the_way.erase(on_the_way.begin());
      }
      EXPECT_EQ(now, FollowerState::reached);
      EXPECT_EQ(state.velocity, Velocity{});
      EXPECT_LE(distance(state.pose.point(), {reverse ? 0.0 : 6.0, 0}), 0.05);
    }
  }
}

TEST(Follower, RefusesWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Stubborn wild({kNan, 0});
  TestRobot robot{Follower(wild)};
  robot.follower.follow(route_through({{0, 0}, {9, 0}}));
  EXPECT_EQ(robot.run(), FollowerState::invalid);
  EXPECT_EQ(robot.state.velocity, Velocity{});

  Stubborn controller({0.5, 0});
  Follower follower(controller);
  follower.follow(route_through({{0, 0}, {kNan, 0}}));
  EXPECT_EQ(follower.step({0, 0, 0}, kPeriod).state, FollowerState::invalid);
  follower.follow(route_through({{0, 0}, {9, 0}}));
  EXPECT_EQ(follower.step({0, 0, 0}, kPeriod).state, FollowerState::driving) << "a valid one helps";
  EXPECT_TRUE(follower.step({kNan, 0, 0}, kPeriod).lost);
  EXPECT_FALSE(follower.step({0, 0, 0}, kPeriod).lost);
  follower.set_velocity({kNan, kNan});
  EXPECT_TRUE(std::isfinite(follower.step({0, 0, 0}, kPeriod).command.linear));
  EXPECT_EQ(follower.step({0, 0, 0}, kNan).state, FollowerState::invalid);
  Follower limitless(controller, {.speed = kNan});
  limitless.follow(route_through({{0, 0}, {9, 0}}));
  const FollowerStep step = limitless.step({0, 0, 0}, kPeriod);
  EXPECT_EQ(step.state, FollowerState::invalid);
  EXPECT_EQ(step.command, Velocity{});
}

TEST(Follower, ItsControllersAnswerFiniteCommands) {
  Random random(11);
  for (const std::string& name : controllers().names()) {
    SCOPED_TRACE(name);
    const auto controller = made_controller(name);
    for (int round = 0; round < 300; ++round) {
      std::vector<Pose> poses{{0, 0, 0}};
      for (int i = 0; i < 5; ++i) {
        Pose next = poses.back();
        const double size = std::pow(10.0, -17 * random.uniform());
        if (random.chance(0.7)) next.x += size * (random.uniform() - 0.5);
        if (random.chance(0.7)) next.y += size * (random.uniform() - 0.5);
        if (random.chance(0.5)) next.heading += size * (random.uniform() - 0.5);
        poses.push_back(next);
      }
      Follower follower(*controller);
      follower.follow(Route(Path::through(poses), {}));
      for (int i = 0; i < 20; ++i) {
        const Pose& near = poses[random.below(poses.size())];
        const double off = std::pow(10.0, -17 * random.uniform());
        const FollowerStep step =
            follower.step({near.x + off, near.y - off, near.heading + off}, kPeriod);
        ASSERT_NE(step.state, FollowerState::invalid);
        ASSERT_TRUE(std::isfinite(step.command.linear) && std::isfinite(step.command.angular));
      }
    }
  }
}

}  // namespace
}  // namespace wend
