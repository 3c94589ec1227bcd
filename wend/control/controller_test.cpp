#include "wend/control/controller.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/control/pid.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

std::unique_ptr<Controller> make(std::string_view name, const OptionValues& options = {}) {
  return make_controller(name, options).value();
}

/// A robot at a pose that follows a line, of which it has come to nothing yet.
struct Scene {
  MapPolyline route;
  MapPose pose;
  Velocity velocity{};

  ControllerInput input() const { return {pose, velocity, &route, 0, 1, 0.05, {}}; }
};

/// One that has begun to drive along a line.
std::unique_ptr<Controller> make_on(const MapPolyline& line, std::string_view name,
                                    const OptionValues& options = {}) {
  auto controller = make(name, options);
  controller->begin(line, {});
  return controller;
}

/// Of a controller that has just begun.
Velocity first_command(std::string_view name, const Scene& scene) {
  return make_on(scene.route, name)->command(scene.input());
}

Scene on_straight_line(const MapPose& pose) {
  return {MapPolyline(std::vector<MapPoint>{{0, 0}, {10, 0}}), pose};
}

TEST(Controllers, AreListedInOrder) {
  EXPECT_EQ(controllers().names(),
            (std::vector<std::string>{"p", "p_moving", "pid", "pure_pursuit", "stanley"}));
  for (const ControllerInfo& info : controllers()) {
    EXPECT_FALSE(info.summary.empty() || info.idea.empty() || info.citation.empty()) << info.name;
    EXPECT_FALSE(info.options.empty()) << info.name;
  }
}

TEST(Controllers, RefuseWrongOptions) {
  for (const ControllerInfo& info : controllers()) {
    EXPECT_FALSE(info.make({{"no_such_gain", "1"}}).has_value()) << info.name;
    for (const OptionInfo& option : info.options) {
      EXPECT_FALSE(info.make({{option.name, "-1"}}).has_value()) << info.name << option.name;
      EXPECT_FALSE(info.make({{option.name, "1e9"}}).has_value()) << info.name << option.name;
      EXPECT_TRUE(info.make({{option.name, option.default_value}})) << info.name << option.name;
    }
  }
}

TEST(Controllers, ThatTurnInPlaceAreUnfitForABicycle) {
  const MotionModel bicycle{.drivetrain = Drivetrain::bicycle};
  for (const ControllerInfo& info : controllers()) {
    EXPECT_EQ(why_unfit(info, {}), std::nullopt) << info.name;
    EXPECT_EQ(why_unfit(info, bicycle).has_value(), info.turns_in_place) << info.name;
  }
  EXPECT_EQ(why_unfit(*controllers().find("p"), bicycle),
            "the controller 'p' turns in place, and a bicycle cannot");
  EXPECT_EQ(why_unfit(*controllers().find("pure_pursuit"), bicycle), std::nullopt);
}

TEST(Controllers, DriveStraightOnAlongALine) {
  for (const std::string& name : controllers().names()) {
    const Velocity wanted = first_command(name, on_straight_line({0, 0, 0}));
    EXPECT_GE(wanted.linear, VelocityLimits{}.speed) << name;
    EXPECT_EQ(wanted.angular, 0) << name;
  }
}

TEST(Controllers, TurnTowardsTheRoute) {
  for (const std::string& name : controllers().names()) {
    EXPECT_GT(first_command(name, on_straight_line({0, 0, -0.3})).angular, 0) << name;
    EXPECT_LT(first_command(name, on_straight_line({0, 0, 0.3})).angular, 0) << name;
    EXPECT_GT(first_command(name, on_straight_line({0, 0, -3})).angular, 0) << name;
    EXPECT_LT(first_command(name, on_straight_line({0, 0.1, 0})).angular, 0) << name;
  }
}

/// Round and round, left and right alike.
RC_GTEST_PROP(Controllers, AreTheSameInAMirror, (std::uint64_t seed)) {
  Random random(seed);
  const auto any = [&](double most) { return (2 * random.uniform() - 1) * most; };
  std::vector<MapPoint> points{{0, 0}};
  for (int i = 0; i < 5; ++i) points.push_back({any(2), any(2)});
  std::vector<MapPoint> mirrored = points;
  for (MapPoint& point : mirrored) point.y = -point.y;
  const MapPose pose{any(2), any(2), any(3)};
  const Velocity velocity{any(0.5), any(1)};
  for (const std::string& name : controllers().names()) {
    const Velocity wanted = first_command(name, {MapPolyline(points), pose, velocity});
    const Velocity other = first_command(name, {MapPolyline(mirrored),
                                                {pose.x, -pose.y, -pose.heading},
                                                {velocity.linear, -velocity.angular}});
    RC_ASSERT(std::abs(wanted.linear - other.linear) < 1e-9);
    RC_ASSERT(std::abs(wanted.angular + other.angular) < 1e-9);
  }
}

TEST(P, TurnsInPlaceUntilItFacesTheWaypoint) {
  const auto p = make("p", {{"turn_above", "0.5"}, {"drive_below", "0.1"}});
  const Scene scene = on_straight_line({});
  const auto speed_at = [&](double heading) {
    return p->command(on_straight_line({0, 0, heading}).input()).linear;
  };
  EXPECT_EQ(speed_at(0.2), 0) << "it begins by turning";
  EXPECT_GT(speed_at(0.05), 0);
  EXPECT_GT(speed_at(0.4), 0) << "it drives on until the error is large";
  EXPECT_EQ(speed_at(-0.6), 0);
  EXPECT_EQ(speed_at(-0.2), 0);
  EXPECT_GT(speed_at(-0.05), 0);
  p->begin(scene.route, {});
  EXPECT_EQ(speed_at(0.2), 0);
}

TEST(PMoving, DrivesSlowerTheLargerTheHeadingError) {
  const auto p = make("p_moving", {{"standing_angle", "1"}});
  const auto speed_at = [&](double heading) {
    return p->command(on_straight_line({0, 0, heading}).input()).linear;
  };
  EXPECT_DOUBLE_EQ(speed_at(0.5), 0.5 * speed_at(0));
  EXPECT_DOUBLE_EQ(speed_at(-0.75), 0.25 * speed_at(0));
  EXPECT_EQ(speed_at(1), 0);
  EXPECT_EQ(speed_at(-2), 0);
}

RC_GTEST_PROP(Pid, WithoutIAndDIsPMoving, (std::uint64_t seed)) {
  Random random(seed);
  const std::string heading_gain = std::to_string(5 * random.uniform());
  const std::string distance_gain = std::to_string(2 * random.uniform());
  const std::string angle = std::to_string(0.1 + random.uniform());
  const auto p = make("p_moving", {{"heading_gain", heading_gain},
                                   {"distance_gain", distance_gain},
                                   {"standing_angle", angle}});
  const auto pid = make("pid", {{"heading_gain", heading_gain},
                                {"distance_gain", distance_gain},
                                {"standing_angle", angle},
                                {"heading_integral", "0"},
                                {"heading_derivative", "0"},
                                {"distance_integral", "0"},
                                {"distance_derivative", "0"}});
  for (int i = 0; i < 50; ++i) {
    const Scene scene =
        on_straight_line({12 * random.uniform(), 2 * random.uniform() - 1, 7 * random.uniform()});
    const Velocity wanted = p->command(scene.input());
    RC_ASSERT(pid->command(scene.input()) == wanted);
  }
}

TEST(PidTerm, SumsAndDifferentiates) {
  PidTerm term({.proportional = 2, .integral = 3, .derivative = 5}, 0);
  EXPECT_DOUBLE_EQ(term.output(1, 1, 0.5, 1e9), 2 * 1 + 3 * 0.5);
  EXPECT_DOUBLE_EQ(term.output(2, 1, 0.5, 1e9), 2 * 2 + 3 * 1.5 + 5 * 2);
  term.reset();
  EXPECT_DOUBLE_EQ(term.output(1, 1, 0.5, 1e9), 2 * 1 + 3 * 0.5);
}

TEST(PidTerm, FiltersTheDerivative) {
  // A step goes through a first-order filter: after its time all but 1/e of the slope has come.
  PidTerm term({.proportional = 0, .integral = 0, .derivative = 1}, 0.5);
  constexpr double kSeconds = 1e-4;
  double slope = term.output(0, 0, kSeconds, 1e9);
  for (int i = 0; i < 5000; ++i) slope = term.output(0, 3 * kSeconds, kSeconds, 1e9);
  EXPECT_NEAR(slope, 3 * (1 - std::exp(-1)), 1e-3);
}

TEST(PidTerm, DoesNotWindUp) {
  PidTerm term({.proportional = 1, .integral = 1, .derivative = 0}, 0);
  for (int i = 0; i < 1000; ++i) term.output(5, 0, 0.1, 1);
  EXPECT_EQ(term.integral(), 0) << "it was at its limit all the time";
  term.output(-0.5, 0, 0.1, 1);
  EXPECT_DOUBLE_EQ(term.integral(), -0.05);
  PidTerm wound({.proportional = 0, .integral = 1, .derivative = 0}, 0);
  for (int i = 0; i < 1000; ++i) wound.output(0.1, 0, 0.1, 1);
  EXPECT_LE(wound.integral(), 1);
  EXPECT_GT(wound.integral(), 0.9);
  wound.output(-5, 0, 0.1, 1);
  EXPECT_LT(wound.integral(), 0.5) << "what drives it back is summed";
}

TEST(Pid, DampsByTheShorterWayRound) {
  const auto pid = make("pid", {{"heading_gain", "0"},
                                {"heading_integral", "0"},
                                {"heading_derivative", "1"},
                                {"filter_time", "0"}});
  pid->command(on_straight_line({0, 0, kPi - 0.01}).input());
  const Velocity wanted = pid->command(on_straight_line({0, 0, kPi + 0.01}).input());
  EXPECT_NEAR(wanted.angular, -0.02 / 0.05, 1e-9);
}

TEST(PurePursuit, StaysOnACircle) {
  // On the route's circle, the circle to a point of it ahead is the route's.
  std::vector<MapPoint> points;
  constexpr double kRadius = 3;
  for (int i = 0; i <= 3600; ++i) {
    const double angle = radians_from(0.1 * i);
    points.push_back({kRadius * std::sin(angle), kRadius * (1 - std::cos(angle))});
  }
  for (const double speed : {0.0, 0.3, 0.5}) {
    const Scene scene{MapPolyline(points), {0, 0, 0}, {speed, 0}};
    const Velocity wanted = first_command("pure_pursuit", scene);
    EXPECT_NEAR(wanted.angular / wanted.linear, 1 / kRadius, 1e-4);
  }
}

TEST(PurePursuit, LooksFartherTheFasterItIs) {
  // Beside a line the curvature of 2 y / d^2 tells how far it looks.
  const auto curvature_at = [](double speed) {
    Scene scene = on_straight_line({0, -0.1, 0});
    scene.velocity.linear = speed;
    const auto pursuit =
        make_on(scene.route, "pure_pursuit", {{"lookahead", "0.3"}, {"lookahead_time", "2"}});
    const Velocity wanted = pursuit->command(scene.input());
    return wanted.angular / wanted.linear;
  };
  EXPECT_NEAR(curvature_at(0), 0.2 / (0.3 * 0.3 + 0.1 * 0.1), 1e-9);
  EXPECT_NEAR(curvature_at(0.5), 0.2 / (1.3 * 1.3 + 0.1 * 0.1), 1e-9);
}

TEST(PurePursuit, SlowsInCurvesAndBeforeTheGoal) {
  Scene scene = on_straight_line({0, 0, 0});
  const auto pursuit = make_on(scene.route, "pure_pursuit",
                               {{"slow_radius", "1"}, {"approach", "2"}, {"min_speed", "0.05"}});
  const double straight = pursuit->command(scene.input()).linear;
  scene.pose.heading = 0.5;
  const Velocity bend = pursuit->command(scene.input());
  EXPECT_DOUBLE_EQ(bend.linear, straight * std::abs(bend.linear / bend.angular))
      << "in proportion to the radius";

  scene.pose = {9, 0, 0};
  ControllerInput near_goal = scene.input();
  near_goal.along = 9;
  EXPECT_DOUBLE_EQ(pursuit->command(near_goal).linear, straight / 2);
  near_goal.along = 9.99;
  near_goal.pose.x = 9.99;
  EXPECT_EQ(pursuit->command(near_goal).linear, 0.05);
}

TEST(PurePursuit, ComesInStraightAndTurnsBackToAnEndThatItPassed) {
  Scene scene = on_straight_line({9.95, 0.02, 0});
  const auto pursuit = make_on(scene.route, "pure_pursuit");
  ControllerInput near_end = scene.input();
  near_end.along = 9.95;
  EXPECT_LT(std::abs(pursuit->command(near_end).angular), 0.1) << "it aims beyond the end";
  near_end.pose.x = 10.15;
  near_end.along = 10;
  EXPECT_EQ(std::abs(pursuit->command(near_end).angular), VelocityLimits{}.turn_rate);
}

TEST(TrackingError, OfWhereTheRobotStandsIsNoTurn) {
  EXPECT_EQ(turn_to({1, 2, 3}, {1, 2}), 0);
  EXPECT_NEAR(turn_to({1, 2, 3}, {0, 2}), kPi - 3, 1e-12);
  EXPECT_NEAR(turn_to({1, 2, -3}, {0, 2}), 3 - kPi, 1e-12);
}

}  // namespace
}  // namespace wend
