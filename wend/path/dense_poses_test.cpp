#include "wend/path/dense_poses.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/testing/random_path.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

TEST(DensePoses, ContainThePathsPosesAndStayNearItsSegments) {
  for (std::uint64_t seed = 0; seed < test::share_of(100U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Path path = test::random_path(random, 12, 9);
    std::vector<Point> dense;
    for (const Pose& pose : dense_poses(path, 0.02)) dense.push_back(pose.point());
    const Polyline line(dense);
    for (const Segment& segment : path.segments()) {
      for (const double share : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0}) {
        const Point point = pose_on(segment, share).point();
        ASSERT_LT(line.nearest(point, 0, line.length()).distance, 0.0201);
      }
    }
    if (!path.driven()) {
      EXPECT_EQ(dense_poses(path), path.poses());
    }
  }
}

TEST(DensePoses, KeepHeadingsInReverseAndOnTurnsInPlace) {
  const Path path = Path::through({{0, 0, 0}, {-5, -5, kPi / 2}, {-5, -5, 2}});
  const auto poses = dense_poses(path);
  EXPECT_GT(poses.size(), 8U);
  EXPECT_EQ(poses.front(), path.poses().front());
  EXPECT_EQ(poses[poses.size() - 2].point(), poses.back().point());
  EXPECT_EQ(poses.back(), path.poses().back());
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_GT(poses[i].heading, poses[i - 1].heading) << "it backs on a left arc";
  }
}

}  // namespace
}  // namespace wend
