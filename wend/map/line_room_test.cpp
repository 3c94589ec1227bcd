#include "wend/map/line_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/random_arc.hpp"
#include "tests/testing/random_map.hpp"
#include "wend/map/arc_clearance.hpp"
#include "wend/map/point_sweep.hpp"

namespace wend {
namespace {

Line random_line(Random& random, const GridMap& map) {
  const double most = test::one_of<double>(random, std::array{0.0, 1.0, 3.0, 12.0});
  const Point from{test::number_between(random, -1, map.width() + 1),
                   test::number_between(random, -1, map.height() + 1)};
  return {from,
          {from.x + test::number_between(random, -most, most),
           from.y + test::number_between(random, -most, most)}};
}

Point near(Random& random, Point point, double distance) {
  const double heading = test::number_between(random, -kPi, kPi);
  return {point.x + distance * std::cos(heading), point.y + distance * std::sin(heading)};
}

TEST(LineRoom, IsWhatBothEndsMayMove) {
  int roomy = 0;
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 4000 && !HasFailure(); ++seed) {
    Random random(seed);
    const GridMap map = test::random_map(random, random.between(1, 14), random.between(1, 14));
    const double radius = test::one_of<double>(random, std::array{0.0, 0.0, 0.3, 1.0, 2.7});
    const FreeSpace space(map, {.robot_radius = radius * map.frame().resolution});
    const Line line = random_line(random, map);
    const auto room = room_along(space, line);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + test::drawing_of(map));
    ASSERT_EQ(room.has_value(), fits_along(space, line));
    ++(room ? roomy : blocked);
    if (!room) continue;
    ASSERT_GE(*room, 0);
    ASSERT_LE(*room, kMostRoom);
    for (int i = 0; i < 10; ++i) {
      const Line moved{near(random, line.from, *room * (1 - 1e-9)),
                       near(random, line.to, *room * (1 - 1e-9))};
      ASSERT_TRUE(fits_along(space, moved)) << *room;
    }
    // Unless it says that there is enough, there is no more.
    if (*room >= kMostRoom / 2) continue;
    const Arc arc{
        {line.from.x, line.from.y, std::atan2(line.to.y - line.from.y, line.to.x - line.from.x)},
        line.length(),
        0};
    ASSERT_NEAR(*room, std::max(arc_clearance(space, arc) - radius, 0.0), 1e-9);
  }
  EXPECT_GT(roomy, 1000);
  EXPECT_GT(blocked, 1000);
}

TEST(LineRoom, IsNotKnownInAGap) {
  const FreeSpace space = test::drawn_space("#.\n.#");
  const Line into{{0.5, 1.5}, {1, 1}};
  const Line out_of{{1, 1}, {0.5, 1.5}};
  EXPECT_TRUE(fits_along(space, into));
  EXPECT_FALSE(room_along(space, into));
  EXPECT_FALSE(room_along(space, out_of));
  EXPECT_EQ(room_along(space, into, Adjacency::edges_and_corners), 0);
  EXPECT_EQ(room_along(space, {{0.5, 1.5}, {0.5, 1}}), 0) << "at an edge";
}

}  // namespace
}  // namespace wend
