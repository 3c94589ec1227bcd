#include "wend/path/lead_out.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/testing/drawn_map.hpp"

namespace wend {
namespace {

constexpr const char* kWall =
    "............\n"
    "............\n"
    "#...........\n"
    "............\n"
    "............\n";

FreeSpace disc_space() {
  return *make_free_space(test::drawn_map(kWall),
                          {.footprint = Footprint::disc(1.3), .outside = OutsidePolicy::free});
}

FreeSpace box_space() {
  return *make_free_space(test::drawn_map(kWall),
                          {.footprint = *parse_footprint("1,0.4; -0.7,0.4; -0.7,-0.4; 1,-0.4"),
                           .outside = OutsidePolicy::free});
}

TEST(LeadOut, IsNoCollisionIfItGoesNoDeeper) {
  const Path away = Path::along({{1.5, 2.5}, {8.5, 2.5}});
  for (const FreeSpace& space : {disc_space(), box_space()}) {
    ASSERT_TRUE(first_collision(away, space));
    const LedPath led = check_with_lead(away, space, 2);
    EXPECT_FALSE(led.collision);
    EXPECT_TRUE(led.ends_free);
    EXPECT_NEAR(led.lead, space.outline() != nullptr ? 0.2 : 0.8, 0.06);
    EXPECT_TRUE(check_with_lead(away, space, 0).collision) << "off";
    EXPECT_TRUE(check_with_lead(away, space, 0.1).collision) << "too long";
  }
}

TEST(LeadOut, IsACollisionIfItGoesDeeper) {
  const Path deeper = Path::through({{1.5, 2.5, 0}, {1.3, 2.5, 0}, {8.5, 2.5, 0}});
  for (const FreeSpace& space : {disc_space(), box_space()}) {
    const LedPath led = check_with_lead(deeper, space, 9);
    ASSERT_TRUE(led.collision);
    EXPECT_EQ(led.collision->piece, 0U);
    EXPECT_LT(led.collision->along, 0.1);
  }
}

TEST(LeadOut, EndsWhereTheRobotFits) {
  const Path back = Path::along({{1.5, 2.5}, {6.5, 2.5}, {1.5, 2.5}});
  const LedPath led = check_with_lead(back, disc_space(), 9);
  ASSERT_TRUE(led.collision);
  EXPECT_EQ(led.collision->piece, 1U);
  EXPECT_NEAR(led.collision->along, 9.2, 0.01);
}

TEST(LeadOut, MayEndBeforeTheRobotFits) {
  const LedPath led = check_with_lead(Path::along({{1.5, 2.5}, {1.7, 2.5}}), disc_space(), 9);
  EXPECT_FALSE(led.collision);
  EXPECT_FALSE(led.ends_free);
}

TEST(LeadOut, IsNothingWhereThePathIsFree) {
  const Path free = Path::along({{4.5, 2.5}, {8.5, 2.5}});
  const LedPath led = check_with_lead(free, disc_space(), 9);
  EXPECT_FALSE(led.collision);
  EXPECT_EQ(led.lead, 0);
}

TEST(LeadOut, JoinsPathsOfEachKind) {
  const Path cells = joined(Path({{0, 0}, {1, 0}}), Path({{1, 0}, {2, 1}}));
  EXPECT_EQ(cells, Path({{0, 0}, {1, 0}, {2, 1}}));
  EXPECT_EQ(lead_of(cells, 1), Path({{0, 0}, {1, 0}}));
  EXPECT_EQ(behind_lead(cells, 1), Path({{1, 0}, {2, 1}}));
  const Path points = joined(Path({{0, 0}, {1, 0}}), Path::along({{1.5, 0.5}, {3.25, 2}}));
  EXPECT_EQ(points, Path::along({{0.5, 0.5}, {1.5, 0.5}, {3.25, 2}}));
  const Path drive =
      joined(Path::through({{0, 0, 0}, {1, 0, 0}}), Path::through({{1, 0, 0}, {1, 0, 1}}));
  EXPECT_EQ(drive, Path::through({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}));
}

TEST(DepthWatch, FollowsARobotOut) {
  DepthWatch watch(disc_space(), {1.5, 2.5, 0});
  EXPECT_TRUE(watch.overlaps());
  EXPECT_FALSE(DepthWatch(watch).go_along({{1.5, 2.5, 0}, -0.3, 0, 0})) << "deeper";
  EXPECT_TRUE(watch.go_along({{1.5, 2.5, 0}, 0.3, 0, 0}));
  EXPECT_FALSE(watch.go_along({{1.8, 2.5, 0}, -0.2, 0, 0})) << "back";
  EXPECT_TRUE(watch.go_along({{1.8, 2.5, 0}, 2, 0, 0}));
  EXPECT_FALSE(watch.overlaps());
}

}  // namespace
}  // namespace wend
