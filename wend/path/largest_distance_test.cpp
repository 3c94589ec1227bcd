#include "wend/path/largest_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/testing/random_path.hpp"
#include "wend/geometry/line.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

/// The largest distance from points along `from`, a hundredth of a cell apart, to the lines of `to`.
double by_samples(const Path& from, const Path& to) {
  const Polyline a = polyline_of(from);
  const Polyline b = polyline_of(to);
  double most = 0;
  const int samples = 1 + static_cast<int>(100 * a.length());
  for (int i = 0; i <= samples; ++i) {
    const Point point = a.at(a.length() * i / samples).point();
    double least = distance(b.points().front(), point);
    for (std::size_t k = 1; k < b.points().size(); ++k) {
      least = std::min(least, distance(Line{b.points()[k - 1], b.points()[k]}, point));
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(LargestDistance, IsThatOfPathsBesideEachOther) {
  const Path path = Path::along({{0, 0}, {10, 0}});
  EXPECT_EQ(largest_distance(path, path), 0);
  EXPECT_EQ(largest_distance(path, Path::along({{0, 2}, {10, 2}})), 2);
  EXPECT_EQ(largest_distance(path, Path::along({{0, 0}, {4, 0}})), 6);
  EXPECT_EQ(largest_distance(Path::along({{3, 4}}), Path::along({{0, 0}})), 5);
  EXPECT_EQ(largest_distance(Path({{0, 0}, {0, 9}}), Path({{0, 0}, {3, 4}, {0, 9}})), 3);
}

TEST(LargestDistance, IsThatOfSamples) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Path a = test::random_waypoint_path(random, 20, 20);
    const Path b = test::random_waypoint_path(random, 20, 20);
    const double expected = std::max(by_samples(a, b), by_samples(b, a));
    EXPECT_NEAR(largest_distance(a, b), expected, 0.26);
    EXPECT_EQ(largest_distance(a, b), largest_distance(b, a));
  }
}

}  // namespace
}  // namespace wend
