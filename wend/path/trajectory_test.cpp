#include "wend/path/trajectory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/testing/random_path.hpp"
#include "tests/testing/share.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr Frame kUnit{};  // a metre a cell

Trajectory timed_along(const Path& path, const TrajectoryLimits& limits,
                       const Frame& frame = kUnit) {
  auto trajectory = Trajectory::along(path, frame, limits);
  EXPECT_TRUE(trajectory) << (trajectory ? "" : trajectory.error().message);
  return *std::move(trajectory);
}

TrajectoryLimits random_limits(Random& random) {
  return {.speed = test::number_between(random, 0.1, 3),
          .turn_rate = test::number_between(random, 0.1, 3),
          .acceleration = test::number_between(random, 0.1, 3),
          .turn_acceleration = test::number_between(random, 0.1, 5),
          .lateral_acceleration = test::number_between(random, 0.1, 3)};
}

struct DrawnTrajectory {
  Path path;
  Frame frame;
  Trajectory trajectory;
};

/// Of any path: cells, waypoints with corners, arcs ahead and in reverse.
DrawnTrajectory random_trajectory(std::uint64_t seed) {
  Random random(seed);
  const Path path = test::random_path(random, 12, 9);
  const Frame frame{.resolution = random.chance(0.5) ? 0.05 : 0.7,
                    .origin = {3, -2, test::number_between(random, -3, 3)}};
  return {path, frame, timed_along(path, random_limits(random), frame)};
}

/// The same with poses anywhere: turns in place and steps to the side.
DrawnTrajectory random_drift(std::uint64_t seed) {
  Random random(seed);
  std::vector<Pose> poses;
  for (int i = random.between(1, 6); i > 0; --i) {
    poses.push_back({test::number_between(random, 0, 5), test::number_between(random, 0, 5),
                     test::number_between(random, -3, 3)});
    if (!random.chance(0.4)) continue;
    Pose turned = poses.back();
    for (int turns = random.between(1, 3); turns > 0; --turns) {
      turned.heading = normalized_angle(turned.heading + test::number_between(random, -0.2, 2));
      poses.push_back(turned);
    }
  }
  const Path path = Path::through(poses);
  return {path, kUnit, timed_along(path, random_limits(random), kUnit)};
}

void for_each_drawn(const std::function<void(const DrawnTrajectory&)>& check) {
  for (std::uint64_t seed = 0; seed < test::share_of(200U); ++seed) {
    SCOPED_TRACE(seed);
    check(seed % 3 == 0 ? random_drift(seed) : random_trajectory(seed));
    if (testing::Test::HasFailure()) return;
  }
}

bool in_place(const MapSegment& segment) { return segment.length == 0; }

double pace_of(const TrajectoryState& state, const MapSegment& segment) {
  return in_place(segment) ? std::abs(state.turn_rate) : std::abs(state.speed);
}

TEST(Trajectory, OfALineIsATrapezoidOrATriangle) {
  const TrajectoryLimits limits{.speed = 2, .acceleration = 0.5};
  const Trajectory far = timed_along(Path::along({{0, 0}, {20, 0}}), limits);
  EXPECT_NEAR(far.duration(), 20 / 2.0 + 2 / 0.5, 1e-12);
  EXPECT_EQ(far.pieces().size(), 3U);
  EXPECT_NEAR(far.at(4).pose.x, 4, 1e-12) << "it has accelerated over v^2 / 2a";
  EXPECT_NEAR(far.at(7).speed, 2, 1e-12);
  const Trajectory near = timed_along(Path::along({{0, 0}, {0, 2}}), limits);
  EXPECT_NEAR(near.duration(), 2 * std::sqrt(2 / 0.5), 1e-12);
  EXPECT_EQ(near.pieces().size(), 2U);
  EXPECT_NEAR(near.at(2).speed, 1, 1e-12);
}

TEST(Trajectory, OfACircleKeepsTheTurnRateAndTheLateralAcceleration) {
  const Path half = Path::through({{0, 0, 0}, {0, 4, kPi}});  // of radius 2
  TrajectoryLimits limits{.speed = 9, .turn_rate = 0.5, .acceleration = 100};
  limits.lateral_acceleration = 1e3;
  EXPECT_NEAR(timed_along(half, limits).at(3).speed, 0.5 * 2, 1e-12);
  limits.turn_rate = 9;
  limits.lateral_acceleration = 0.5;
  EXPECT_NEAR(timed_along(half, limits).at(3).speed, std::sqrt(0.5 * 2), 1e-12);
  EXPECT_NEAR(timed_along(half, limits).smallest_turning_radius(), 2, 1e-12);
}

TEST(Trajectory, StopsAtACornerAndTurnsInPlace) {
  const TrajectoryLimits limits{
      .speed = 1, .turn_rate = 1, .acceleration = 1, .turn_acceleration = 1};
  const Trajectory trajectory = timed_along(Path::along({{0, 0}, {1, 0}, {1, 1}}), limits);
  const double turn = kPi / 2 / 1 + 1;  // a trapezoid: pi / 2 is more than w^2 / a
  EXPECT_NEAR(trajectory.duration(), 2 + turn + 2, 1e-12);
  const TrajectoryState middle = trajectory.at(2 + turn / 2);
  EXPECT_NEAR(middle.pose.heading, kPi / 4, 1e-12);
  EXPECT_EQ(middle.pose.point(), (MapPoint{1, 0}));
  EXPECT_EQ(middle.speed, 0);
  EXPECT_EQ(middle.turn_rate, 1);
  EXPECT_EQ(trajectory.smallest_turning_radius(), 0);
}

TEST(Trajectory, StopsWhereACarChangesGear) {
  const Path path = Path::through({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}});
  const TrajectoryLimits limits{.speed = 9, .acceleration = 1};
  const Trajectory trajectory = timed_along(path, limits);
  const double there = 2 * std::sqrt(2);
  EXPECT_NEAR(trajectory.duration(), there + 2, 1e-12);
  EXPECT_NEAR(trajectory.at(there).speed, 0, 1e-9);
  EXPECT_NEAR(trajectory.at(there + 1).speed, -1, 1e-9);
  EXPECT_NEAR(trajectory.length(), 3, 1e-12);
}

TEST(Trajectory, DoesNotStopWhereArcsAndLinesJoin) {
  const Path path = Path::through({{0, 0, 0}, {3, 0, 0}, {5, 2, kPi / 2}, {5, 5, kPi / 2}});
  const TrajectoryLimits limits{.speed = 1, .turn_rate = 0.25};
  const Trajectory trajectory = timed_along(path, limits);
  for (const TrajectoryState& state : trajectory.samples(0.01)) {
    if (state.time < 1 || state.time > trajectory.duration() - 1) continue;
    ASSERT_GE(state.speed, 0.4999) << "0.25 rad/s on a circle of 2 m";
  }
}

TEST(Trajectory, StopsOnlyWhereTheDirectionOfTravelJumpsByMoreThanTenDegrees) {
  const TrajectoryLimits limits{.speed = 9, .acceleration = 1};
  const auto duration_with_jump = [&](double degrees) {
    const double aside = 2 * std::tan(radians_from(degrees));  // at the same heading
    return timed_along(Path::through({{0, 0, 0}, {2, 0, 0}, {4, aside, 0}}), limits).duration();
  };
  EXPECT_NEAR(duration_with_jump(9), 2 * std::sqrt(4.0), 0.1);
  EXPECT_NEAR(duration_with_jump(11), 4 * std::sqrt(2.0), 0.1);
}

TEST(Trajectory, KeepsTurningThroughTurnsInPlaceOneWay) {
  const Path path = Path::through({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
  const TrajectoryLimits limits{.turn_rate = 9, .turn_acceleration = 1};
  EXPECT_NEAR(timed_along(path, limits).duration(), 2 * std::sqrt(3), 1e-9);
}

TEST(Trajectory, OfOnePointStandsThere) {
  const Trajectory trajectory = timed_along(Path({Cell{2, 3}}), {});
  EXPECT_EQ(trajectory.duration(), 0);
  EXPECT_EQ(trajectory.at(7).pose, (MapPose{2.5, 3.5, 0}));
  EXPECT_EQ(trajectory.samples(0.1).size(), 1U);
  EXPECT_EQ(timed_along(Path({Cell{2, 3}, Cell{2, 3}}), {}).duration(), 0);
}

TEST(Trajectory, RefusesWrongLimitsAndPaths) {
  const Path line = Path::along({{0, 0}, {1, 0}});
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {0.0, -1.0, infinite, std::nan("")}) {
    const auto refused = Trajectory::along(line, kUnit, {.turn_rate = wrong});
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().status, Status::invalid_option);
    EXPECT_EQ(refused.error().where, "turn_rate");
    EXPECT_FALSE(Trajectory::along(line, kUnit, {.lateral_acceleration = wrong})) << wrong;
  }
  for (const Path& path :
       {Path(), Path::along({{0, 0}, {infinite, 0}}), Path::along({{0, 0}, {std::nan(""), 0}}),
        Path::through({{0, 0, 0}, {0, 0, infinite}}), Path::along({{-1e308, 0}, {1e308, 0}})}) {
    const auto refused = Trajectory::along(path, kUnit);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Status::unsupported_query);
  }
}

/// The positions and the values, and their finite differences, at 1 kHz.
void expect_within_limits(const DrawnTrajectory& drawn) {
  constexpr double kPeriod = 1e-3;
  constexpr double kRounding = 1e-6;
  const Trajectory& trajectory = drawn.trajectory;
  const TrajectoryLimits& limits = trajectory.limits();
  const auto states = trajectory.samples(kPeriod);
  const auto within = [](double value, double limit) {
    return std::abs(value) <= limit * (1 + kRounding) + kRounding;
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    const TrajectoryState& now = states[i];
    ASSERT_TRUE(within(now.speed, limits.speed)) << now.time;
    ASSERT_TRUE(within(now.turn_rate, limits.turn_rate)) << now.time;
    ASSERT_TRUE(within(now.speed * now.turn_rate, limits.lateral_acceleration)) << now.time;
    if (i == 0) continue;
    const TrajectoryState& last = states[i - 1];
    const double seconds = now.time - last.time;
    if (seconds < kPeriod / 2) continue;  // the last one: rounding would count
    const double moved = distance(now.pose.point(), last.pose.point());
    const double turned = normalized_angle(now.pose.heading - last.pose.heading);
    ASSERT_TRUE(within(moved / seconds, limits.speed)) << now.time;
    ASSERT_TRUE(within(turned / seconds, limits.turn_rate)) << now.time;
    ASSERT_TRUE(within((now.speed - last.speed) / seconds, limits.acceleration)) << now.time;
    if (now.speed != 0 || last.speed != 0) continue;
    ASSERT_TRUE(within((now.turn_rate - last.turn_rate) / seconds, limits.turn_acceleration))
        << now.time;
  }
}

TEST(Trajectory, ExceedsNoLimitAtOneKilohertz) {
  for_each_drawn([](const DrawnTrajectory& drawn) { expect_within_limits(drawn); });
}

TEST(Trajectory, LeadsFromRestToRestAlongThePath) {
  for_each_drawn([](const DrawnTrajectory& drawn) {
    const Trajectory& trajectory = drawn.trajectory;
    const auto near = [](const MapPose& pose, const MapPose& wanted) {
      return distance(pose.point(), wanted.point()) < 1e-6 &&
             std::abs(normalized_angle(pose.heading - wanted.heading)) < 1e-5;
    };
    const auto poses = drawn.path.poses();
    EXPECT_TRUE(near(trajectory.at(0).pose, drawn.frame.to_metres(poses.front())));
    EXPECT_TRUE(near(trajectory.at(trajectory.duration()).pose,
                     end_of(trajectory.segments().empty()
                                ? MapSegment{drawn.frame.to_metres(poses.front()), 0, 0, 0}
                                : trajectory.segments().back())));
    EXPECT_NEAR(trajectory.length(), drawn.path.length() * drawn.frame.resolution, 1e-9);
    double time = 0;
    for (const TrajectoryPiece& piece : trajectory.pieces()) {
      EXPECT_EQ(piece.time, time) << "no gap";
      time += piece.duration;
      const MapSegment& segment = trajectory.segments()[piece.segment];
      const double extent = std::abs(in_place(segment) ? segment.turn : segment.length);
      const TrajectoryState state = trajectory.at(piece.time + piece.duration / 2);
      const double along = piece.along + (piece.speed + piece.acceleration * piece.duration / 4) *
                                             piece.duration / 2;
      EXPECT_TRUE(near(state.pose, pose_on(segment, along / extent)));
    }
    EXPECT_EQ(time, trajectory.duration());
    if (trajectory.pieces().empty()) return;
    const TrajectoryPiece& last = trajectory.pieces().back();
    EXPECT_EQ(trajectory.pieces().front().speed, 0);
    EXPECT_NEAR(last.speed + last.acceleration * last.duration, 0, 1e-6);
  });
}

/// Where the speed cannot be raised: at every moment a limit on speed or acceleration is active.
TEST(Trajectory, CannotBeFasterAnywhere) {
  for_each_drawn([](const DrawnTrajectory& drawn) {
    constexpr double kRounding = 1e-6;
    const Trajectory& trajectory = drawn.trajectory;
    const TrajectoryLimits& limits = trajectory.limits();
    for (const TrajectoryPiece& piece : trajectory.pieces()) {
      const MapSegment& segment = trajectory.segments()[piece.segment];
      const double steepest = in_place(segment) ? limits.turn_acceleration : limits.acceleration;
      const TrajectoryState state = trajectory.at(piece.time + piece.duration / 2);
      const double pace = pace_of(state, segment);
      const double raised = 1 + 1e-5;
      const double lateral = std::abs(state.speed * state.turn_rate) * raised * raised;
      const bool at_speed = std::abs(state.speed) * raised > limits.speed ||
                            std::abs(state.turn_rate) * raised > limits.turn_rate ||
                            lateral > limits.lateral_acceleration;
      const double change = (pace - piece.speed) / (piece.duration / 2);
      const bool changes = std::abs(std::abs(change) - steepest) < 1e-3 * steepest + kRounding;
      ASSERT_TRUE(at_speed || changes || piece.duration < kRounding)
          << piece.time << ": " << pace << " " << change;
    }
  });
}

/// Accelerating never begins where braking could have ended later, and the other way round: between
/// braking and accelerating lies a place where the speed is at a limit of its own.
TEST(Trajectory, IsSlowestOnlyWhereALimitOnTheSpeedHolds) {
  for_each_drawn([](const DrawnTrajectory& drawn) {
    const Trajectory& trajectory = drawn.trajectory;
    const auto pieces = trajectory.pieces();
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (!(pieces[i - 1].acceleration < 0 && pieces[i].acceleration > 0)) continue;
      const MapSegment& before = trajectory.segments()[pieces[i - 1].segment];
      const MapSegment& after = trajectory.segments()[pieces[i].segment];
      if (pieces[i].speed == 0) continue;  // a stop
      ASSERT_FALSE(in_place(before) || in_place(after));
      const double slower = std::min(fastest_on(before.turn / before.length, trajectory.limits()),
                                     fastest_on(after.turn / after.length, trajectory.limits()));
      ASSERT_NEAR(pieces[i].speed, slower, 1e-9);
    }
  });
}

/// An independent reference: places along the way, whose speeds are lowered from the highest ones until
/// no two neighbours differ by more than the acceleration allows.
class Relaxation {
 public:
  void add(const MapSegment& segment, const TrajectoryLimits& limits) {
    const double extent = std::abs(in_place(segment) ? segment.turn : segment.length);
    const double bend = in_place(segment) ? 0 : std::abs(segment.turn / segment.length);
    double fastest = in_place(segment) ? limits.turn_rate : limits.speed;
    if (bend > 0) {
      fastest = std::min(
          {fastest, limits.turn_rate / bend, std::sqrt(limits.lateral_acceleration / bend)});
    }
    acceleration_ = in_place(segment) ? limits.turn_acceleration : limits.acceleration;
    speeds_.back() = std::min(speeds_.back(), fastest);
    // Close together near both ends, where the speed changes within a short way.
    const auto share = [](int i) { return (1 - std::cos(kPi * i / kPlaces)) / 2; };
    for (int i = 0; i < kPlaces; ++i) {
      steps_.push_back(extent * (share(i + 1) - share(i)));
      speeds_.push_back(fastest);
    }
  }

  /// The seconds to a stop here.
  double stop() {
    speeds_.back() = 0;
    bool changed = true;
    while (changed) {
      changed = false;
      for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::size_t back = steps_.size() - 1 - i;
        changed |= lower(i + 1, i, steps_[i]);
        changed |= lower(back, back + 1, steps_[back]);
      }
    }
    double seconds = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      seconds += 2 * steps_[i] / (speeds_[i] + speeds_[i + 1]);
    }
    speeds_ = {0};
    steps_.clear();
    return seconds;
  }

 private:
  bool lower(std::size_t fast, std::size_t slow, double step) {
    const double reached = std::sqrt(speeds_[slow] * speeds_[slow] + 2 * acceleration_ * step);
    if (speeds_[fast] <= reached * (1 + 1e-12)) return false;
    speeds_[fast] = reached;
    return true;
  }

  static constexpr int kPlaces = 1000;  // of a segment

  double acceleration_ = 0;
  std::vector<double> speeds_{0};
  std::vector<double> steps_;
};

TEST(Trajectory, TakesAsLongAsAnIndependentRelaxation) {
  for (std::uint64_t seed = 0; seed < test::share_of(100U); ++seed) {
    const Trajectory trajectory = random_trajectory(seed).trajectory;
    const auto segments = trajectory.segments();
    Relaxation relaxation;
    double seconds = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      relaxation.add(segments[i], trajectory.limits());
      const bool stops = i + 1 == segments.size() || in_place(segments[i]) ||
                         in_place(segments[i + 1]) ||
                         segments[i].length * segments[i + 1].length < 0;
      if (stops) seconds += relaxation.stop();
    }
    EXPECT_NEAR(trajectory.duration(), seconds, 1e-3 * seconds) << seed;
  }
}

TEST(Trajectory, HasNoTwoSamplesAtItsEnd) {
  // Of 2 s; rounding makes it a little longer for some lengths.
  for (int i = 1; i < 200; ++i) {
    const double speed = 0.1 * i;
    const TrajectoryLimits limits{.speed = speed, .acceleration = 1e6};
    const auto samples = timed_along(Path::along({{0, 0}, {2 * speed, 0}}), limits).samples(0.1);
    ASSERT_GT(samples.back().time - samples[samples.size() - 2].time, 1e-8) << speed;
  }
}

std::vector<TimedPose> timed_poses(const Trajectory& trajectory, double period, double start = 0) {
  std::vector<TimedPose> poses;
  for (const TrajectoryState& state : trajectory.samples(period)) {
    poses.push_back({start + state.time, state.pose});
  }
  return poses;
}

TEST(TrajectoryThrough, ItsOwnSamplesIsNearlyTheSame) {
  for_each_drawn([](const DrawnTrajectory& drawn) {
    const Trajectory& wanted = drawn.trajectory;
    constexpr double kPeriod = 0.05;
    const auto poses = timed_poses(wanted, kPeriod, 17);
    const auto again = Trajectory::through(poses);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_NEAR(again->duration(), wanted.duration(), 1e-9);
    EXPECT_LE(again->length(), 1.01 * wanted.length()) << "shorter, but for turns on the way";
    EXPECT_LE(again->limits().speed, wanted.limits().speed + 1e-6);
    for (const TimedPose& at : poses) {
      const MapPose pose = again->at(at.time - 17).pose;
      ASSERT_LT(distance(pose.point(), at.pose.point()), 1e-6) << at.time;
      ASSERT_LT(std::abs(normalized_angle(pose.heading - at.pose.heading)), 1e-6) << at.time;
    }
    const double between = wanted.limits().speed * kPeriod;
    for (double time = 0; time < wanted.duration(); time += 0.013) {
      ASSERT_LT(distance(again->at(time).pose.point(), wanted.at(time).pose.point()), between);
    }
  });
}

TEST(TrajectoryThrough, WaitsBetweenEqualPosesAndDrivesEachStretchAtOneSpeed) {
  const std::vector<TimedPose> poses{
      {3, {1, 1, 0}}, {5, {1, 1, 0}}, {6, {3, 1, 0}}, {8, {2, 1, 0}}, {10, {2, 1, 1}}};
  const auto trajectory = Trajectory::through(poses);
  ASSERT_TRUE(trajectory) << trajectory.error().message;
  EXPECT_EQ(trajectory->duration(), 7);
  EXPECT_EQ(trajectory->at(1).pose, (MapPose{1, 1, 0}));
  EXPECT_EQ(trajectory->at(1).speed, 0);
  EXPECT_EQ(trajectory->at(1).turn_rate, 0);
  EXPECT_NEAR(trajectory->at(2.25).pose.x, 1.5, 1e-12);
  EXPECT_EQ(trajectory->at(2.25).speed, 2);
  EXPECT_EQ(trajectory->at(4).speed, -0.5) << "in reverse";
  EXPECT_NEAR(trajectory->at(6).turn_rate, 0.5, 1e-12) << "in place";
  EXPECT_EQ(trajectory->at(99).pose, (MapPose{2, 1, 1}));
  EXPECT_EQ(trajectory->limits().speed, 2);
}

TEST(TrajectoryThrough, RefusesWhatIsNoTrajectory) {
  const auto fault = [](const std::vector<TimedPose>& poses) {
    const auto trajectory = Trajectory::through(poses);
    return trajectory ? std::string() : trajectory.error().message;
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault({}), "the trajectory has no poses");
  EXPECT_EQ(fault({{0, {}}, {0, {1, 0, 0}}}),
            "pose 1 of the trajectory is not later than the pose before it");
  EXPECT_EQ(fault({{0, {}}, {1, {1, 0, 0}}, {0.5, {2, 0, 0}}}),
            "pose 2 of the trajectory is not later than the pose before it");
  EXPECT_EQ(fault({{0, {}}, {1, {kNone, 0, 0}}}),
            "pose 1 of the trajectory contains NaN or infinity");
  EXPECT_EQ(fault({{kNone, {}}}), "pose 0 of the trajectory contains NaN or infinity");
  EXPECT_EQ(fault({{5, {1, 2, 3}}}), "") << "a robot that stands";
}

TEST(Trajectory, HasNoSamplesForAPeriodThatIsNone) {
  const Trajectory trajectory = timed_along(Path::along({{0, 0}, {1, 0}}), {});
  for (const double period : {std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0, 5e-324}) {
    EXPECT_TRUE(trajectory.samples(period).empty()) << period;
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(trajectory.at(nan).pose, trajectory.at(0).pose);
}

}  // namespace
}  // namespace wend
