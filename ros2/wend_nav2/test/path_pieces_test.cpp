// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/path_pieces.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "wend/geometry/angle.hpp"

namespace wend_nav2 {
namespace {

using Poses = std::vector<wend::MapPose>;

RC_GTEST_PROP(PathPieces, ARouteIsAsLongAsThePathAndEndsAsItDoes, ()) {
  const int count = *rc::gen::inRange(1, 20);
  Poses path;
  double length = 0;
  for (int i = 0; i < count; ++i) {
    const int x = *rc::gen::inRange(0, 4);
    const int y = *rc::gen::inRange(0, 4);
    const int heading = *rc::gen::inRange(-3, 4);
    path.push_back({x * 1.0, y * 1.0, heading * 1.0});
    if (i > 0) length += distance(path[path.size() - 2].point(), path.back().point());
  }
  const wend::Route route = route_along(path);
  RC_ASSERT(std::abs(route.length() - length) < 1e-9);
  RC_ASSERT(route.end() == path.back());
  RC_ASSERT(route.final_heading() == path.back().heading);
  for (const wend::RouteLeg& leg : route.legs()) {
    const auto points = leg.line.points();
    for (std::size_t i = 2; i < points.size(); ++i) {
      const double dot = (points[i].x - points[i - 1].x) * (points[i - 1].x - points[i - 2].x) +
                         (points[i].y - points[i - 1].y) * (points[i - 1].y - points[i - 2].y);
      RC_ASSERT(dot >= 0);
    }
  }
}

TEST(PathPieces, ReversalsAreLegsOfTheirOwn) {
  const double up = wend::kPi / 2;
  const wend::Route route = route_along(
      Poses{{0, 0, up}, {0, 1, up}, {0, 2, up}, {0, 1.5, up}, {0, 1, up}, {0, 1.5, up}});
  ASSERT_EQ(route.legs().size(), 3U);
  EXPECT_FALSE(route.legs()[0].reverse);
  EXPECT_TRUE(route.legs()[1].reverse);
  EXPECT_FALSE(route.legs()[2].reverse);
  for (const wend::RouteLeg& leg : route.legs()) EXPECT_FALSE(leg.turn_first);
}

TEST(PathPieces, ALegThatFacesAlongXMayBeAReverseOne) {
  const wend::Route route =
      route_along(Poses{{0, 0, 0.2}, {1, 0.1, 0.1}, {2, 0.1, 0}, {1.5, 0.1, 0}, {1, 0.1, 0}});
  ASSERT_EQ(route.legs().size(), 2U);
  EXPECT_FALSE(route.legs()[0].reverse);
  EXPECT_TRUE(route.legs()[1].reverse);
}

TEST(PathPieces, AfterATurnInPlaceTheNextLegBeginsWithIt) {
  const wend::Route route =
      route_along(Poses{{0, 0, 0}, {1, 0, 0}, {1, 0, wend::kPi / 2}, {1, 1, wend::kPi / 2}});
  ASSERT_EQ(route.legs().size(), 2U);
  EXPECT_FALSE(route.legs()[0].turn_first);
  EXPECT_TRUE(route.legs()[1].turn_first);
  EXPECT_FALSE(route.legs()[1].reverse);
}

TEST(PathPieces, PosesWithoutHeadingsAreDrivenAhead) {
  const wend::Route route = route_along(Poses{{2, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  ASSERT_EQ(route.legs().size(), 1U);
  EXPECT_FALSE(route.legs()[0].reverse);
}

TEST(PathPieces, ABendOfARightAngleIsNotACut) {
  EXPECT_EQ(cuts_of(Poses{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(cuts_of(Poses{{0, 0, 0}, {1, 0, 0}, {0.9, 1, 0}}), (std::vector<std::size_t>{0, 1, 2}));
}

}  // namespace
}  // namespace wend_nav2
