#include "wend/space/se2/goal_ring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>

#include "wend/base/random.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr int kHeadings = 24;

/// The cost from a place of the table with one of its headings, by the steering alone.
float connected(const Steering& steering, Point place, int heading) {
  std::array<Connection, 1> best;
  const Pose from{place.x, place.y, wrapped_angle(heading * (2 * kPi / kHeadings))};
  constexpr double kAnyCost = std::numeric_limits<double>::infinity();
  EXPECT_EQ(steering.connect(from, {0, 0, 0}, 0, kAnyCost, best), 1);
  return static_cast<float>(best[0].cost);
}

/// At its places a ring says what the steering says, whatever it was asked before, to the last bit.
TEST(GoalRing, SaysAtItsPlacesWhatTheSteeringSays) {
  for (const DriveKind kind :
       {DriveKind::reeds_shepp, DriveKind::dubins, DriveKind::differential, DriveKind::omni}) {
    const Steering steering(kind, 8, {.reverse = 2, .turn = 1.2, .gear_change = 3, .spin = 1});
    GoalRing ring(steering);
    constexpr double kUnit = 4;  // half the radius
    Random random(1);
    for (int i = 0; i < 60; ++i) {
      const Point place{kUnit * random.between(-9, 9), kUnit * random.between(0, 9)};
      SCOPED_TRACE("place " + std::to_string(place.x) + "," + std::to_string(place.y));
      const int heading = random.between(0, kHeadings - 1);
      const Pose pose{place.x, place.y, wrapped_angle(heading * (2 * kPi / kHeadings))};
      const auto cost = [&] { return ring.cost(pose, {0, 0, 0}); };
      const auto least_cost = [&] { return ring.least_cost(place, {0, 0, 0}); };
      const bool cost_first = random.chance(0.5);
      const double first = cost_first ? cost() : least_cost();
      const double second = cost_first ? least_cost() : cost();
      float least = std::numeric_limits<float>::infinity();
      for (int k = 0; k < kHeadings; ++k) {
        least = std::min(least, connected(steering, place, k));
      }
      EXPECT_EQ(cost_first ? second : first, least);
      EXPECT_NEAR(cost_first ? first : second, connected(steering, place, heading), 1e-4);
    }
  }
}

}  // namespace
}  // namespace wend
