#include "wend_ros/replanning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "wend/path/polyline.hpp"

namespace wend_ros {
namespace {

using wend::CellBox;
using wend::Path;
using wend::Pose;
using wend::SpaceChange;

SpaceChange box(int x, int y, int width = 1, int height = 1) {
  return {false, {{{x, y}, {x + width, y + height}}}};
}

/// From (0.5, 5.5) to (20.5, 5.5).
Path along_a_row() { return Path::along({{0.5, 5.5}, {20.5, 5.5}}); }

TEST(TouchesAhead, WhatLiesOnThePathDoes) {
  EXPECT_TRUE(touches_ahead(box(10, 5), along_a_row(), {}));
  EXPECT_TRUE(touches_ahead(box(10, 0, 1, 20), along_a_row(), {}));
  EXPECT_FALSE(touches_ahead(box(10, 8), along_a_row(), {}));
  EXPECT_FALSE(touches_ahead(box(23, 5), along_a_row(), {}));
  EXPECT_FALSE(touches_ahead({}, along_a_row(), {}));
  EXPECT_TRUE(touches_ahead(SpaceChange::of_everything(), along_a_row(), {}));
}

TEST(TouchesAhead, WhatTheRobotHasPassedDoesNot) {
  const Pose robot{12.2, 5.4, 0};
  EXPECT_FALSE(touches_ahead(box(8, 5), along_a_row(), robot));
  EXPECT_TRUE(touches_ahead(box(15, 5), along_a_row(), robot));
}

TEST(TouchesAhead, OneOfManyBoxesIsEnough) {
  SpaceChange change = box(10, 20);
  change.boxes.push_back({{3, 5}, {4, 6}});
  EXPECT_TRUE(touches_ahead(change, along_a_row(), {}));
}

TEST(TouchesAhead, APathOfOnePointIsThere) {
  const Path here = Path::along({{3.5, 3.5}});
  EXPECT_TRUE(touches_ahead(box(3, 3), here, {}));
  EXPECT_FALSE(touches_ahead(box(6, 3), here, {}));
}

/// Against points every hundredth of a cell: they find what is touched, but for corners that a line
/// hardly cuts.
TEST(TouchesAhead, IsWhatPointsOnThePathSay) {
  std::mt19937 random(7);
  const auto draw = [&](double most) {
    return std::uniform_real_distribution<double>(0, most)(random);
  };
  int touched = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<wend::Point> points;
    for (int n = 0; n < 4; ++n) points.push_back({draw(40), draw(40)});
    const SpaceChange change = box(static_cast<int>(draw(40)), static_cast<int>(draw(40)),
                                   1 + static_cast<int>(draw(5)), 1 + static_cast<int>(draw(5)));
    const CellBox grown = change.boxes[0].grown_by(1);
    double nearest = 1e9;  // from a point of the path to the box
    const wend::Polyline line(points);
    for (double along = 0; along < line.length(); along += 0.01) {
      const wend::Point at = line.at(along).point();
      nearest =
          std::min(nearest, std::hypot(std::max({grown.begin.x - at.x, at.x - grown.end.x, 0.0}),
                                       std::max({grown.begin.y - at.y, at.y - grown.end.y, 0.0})));
    }
    const bool touches = touches_ahead(change, Path::along(points), {});
    if (nearest == 0) ASSERT_TRUE(touches) << i;
    if (nearest > 0.01) ASSERT_FALSE(touches) << i;
    touched += touches ? 1 : 0;
  }
  EXPECT_GT(touched, 300);
  EXPECT_LT(touched, 2700);
}

/// After a plan along the row on version 1.
Replanning planned(ReplanOnChange when) {
  Replanning replanning;
  replanning.set(when);
  replanning.begin();
  EXPECT_FALSE(replanning.end(along_a_row(), 1));
  return replanning;
}

TEST(Replanning, IsForChangesAhead) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  EXPECT_FALSE(replanning.change(2, box(10, 9), {}));
  EXPECT_TRUE(replanning.change(3, box(10, 5), {}));
}

TEST(Replanning, IsForEveryChangeOrForNoneIfToldSo) {
  Replanning always = planned(ReplanOnChange::always);
  EXPECT_TRUE(always.change(2, box(10, 9), {}));
  EXPECT_FALSE(always.change(3, {}, {})) << "nothing has changed";
  Replanning never = planned(ReplanOnChange::never);
  EXPECT_FALSE(never.change(2, box(10, 5), {}));
  EXPECT_FALSE(never.change(3, SpaceChange::of_everything(), {}));
}

TEST(Replanning, IsForEveryChangeWhileThereIsNoPath) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  replanning.begin();
  EXPECT_FALSE(replanning.end({}, 2));
  EXPECT_TRUE(replanning.change(3, box(30, 30), {})) << "it may have opened a way";
}

TEST(Replanning, AChangeDuringASearchCountsAtItsEnd) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  replanning.begin();
  EXPECT_FALSE(replanning.change(2, box(10, 5), {})) << "the search may find another path";
  EXPECT_FALSE(replanning.end(Path::along({{0.5, 9.5}, {20.5, 9.5}}), 1)) << "it did";
  replanning.begin();
  EXPECT_FALSE(replanning.change(3, box(10, 9), {}));
  EXPECT_TRUE(replanning.end(Path::along({{0.5, 9.5}, {20.5, 9.5}}), 2));
}

TEST(Replanning, WhatTheSearchKnewAlreadyDoesNotCount) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  replanning.begin();
  EXPECT_FALSE(replanning.change(2, box(10, 5), {}));
  EXPECT_FALSE(replanning.end(along_a_row(), 2)) << "it planned on version 2";
  EXPECT_FALSE(replanning.change(2, box(10, 5), {})) << "the news of it came late";
  EXPECT_TRUE(replanning.change(3, box(10, 5), {}));
}

}  // namespace
}  // namespace wend_ros
