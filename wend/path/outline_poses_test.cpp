#include "wend/path/outline_poses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/testing/random_path.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using testing::ElementsAre;

TEST(OutlinePoses, AreEvenlySpacedFromTheStartToTheGoal) {
  const Path path = Path::along({{0, 0}, {10, 0}});
  EXPECT_EQ(outline_poses(path, 1).size(), 4U) << "three gaps of 3.33, not one of 0.4 at the end";
  EXPECT_NEAR(outline_poses(path, 1)[1].x, 10 / 3.0, 1e-6);
  EXPECT_EQ(outline_poses(Path::along({{0, 0}, {9.6, 0}}), 1).size(), 4U);
  EXPECT_THAT(outline_poses(Path::along({{0, 0}, {2, 0}}), 1),
              ElementsAre(Pose{0, 0, 0}, Pose{2, 0, 0}));
}

TEST(OutlinePoses, HaveThePathsHeadingsOnTurnsInPlaceReverseAndStepsToTheSide) {
  const Path turn = Path::through({{3, 3, 0}, {3, 3, 1}, {3, 3, 2}});
  EXPECT_THAT(outline_poses(turn, 1), ElementsAre(Pose{3, 3, 0}, Pose{3, 3, 2}));
  const Path turn_first = Path::through({{0, 0, kPi}, {0, 0, 0}, {9, 0, 0}});
  EXPECT_EQ(outline_poses(turn_first, 1).front(), (Pose{0, 0, kPi}));
  const Path aside = Path::through({{0, 0, 0}, {0, 7, 0}});
  for (const Pose& pose : outline_poses(aside, 1)) EXPECT_EQ(pose.heading, 0);
  const Path back = Path::through({{0, 0, 0}, {-7, 0, 0}});
  for (const Pose& pose : outline_poses(back, 1)) EXPECT_EQ(pose.heading, 0);
  EXPECT_EQ(outline_poses(back, 1).size(), 3U);
}

TEST(OutlinePoses, OfAnyPathBeginAndEndWithItAndAreFew) {
  for (std::uint64_t seed = 0; seed < test::share_of(100U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Path path = test::random_path(random, 12, 9);
    const auto poses = outline_poses(path, 0.3);
    EXPECT_EQ(poses.front().point(), path.points().front());
    EXPECT_LT(distance(poses.back().point(), path.points().back()), 1e-9);
    if (path.driven()) {
      EXPECT_EQ(poses.front(), path.poses().front());
      EXPECT_EQ(poses.back(), path.poses().back());
    }
    EXPECT_LE(static_cast<double>(poses.size()) - 2, path.length() / (1.6 * 0.6));
    EXPECT_LE(outline_poses(path, 1e-5).size(), 201U);
  }
}

}  // namespace
}  // namespace wend
