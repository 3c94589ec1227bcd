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
    ASSERT_TRUE(nearest != 0 || touches) << i;
    ASSERT_TRUE(nearest <= 0.01 || !touches) << i;
    touched += touches ? 1 : 0;
  }
  EXPECT_GT(touched, 300);
  EXPECT_LT(touched, 2700);
}

/// 24 x 24 cells of 1 m for a disc of 1 m, free but for one.
wend::FreeSpace space_with(wend::Cell obstacle, double clearance_distance = 0) {
  wend::Grid<wend::CellState> cells(24, 24, wend::CellState::free);
  cells[obstacle] = wend::CellState::occupied;
  return *wend::make_free_space(
      *wend::make_grid_map(cells),
      {.footprint = wend::Footprint::disc(1), .clearance_distance = clearance_distance});
}

TEST(SpoilsAhead, WhatBlocksThePathDoes) {
  EXPECT_TRUE(spoils_ahead(box(10, 5), space_with({10, 5}), along_a_row(), {}));
  EXPECT_TRUE(spoils_ahead(box(9, 5, 3, 3), space_with({10, 6}), along_a_row(), {}))
      << "the robot does not fit beside it";
  EXPECT_FALSE(spoils_ahead(box(10, 5), space_with({20, 20}), along_a_row(), {}))
      << "a cell that has been seen to be free";
  EXPECT_FALSE(spoils_ahead(box(10, 5), space_with({10, 5}), along_a_row(), Pose{14, 5.5, 0}))
      << "that is behind";
}

TEST(SpoilsAhead, WhatMayCostMoreDoesSoToo) {
  EXPECT_TRUE(spoils_ahead(box(10, 5), space_with({20, 20}, 3), along_a_row(), {}));
}

/// After a plan along the row on version 1.
Replanning planned(ReplanOnChange when) {
  Replanning replanning;
  replanning.set(when);
  replanning.begin();
  EXPECT_FALSE(replanning.end(along_a_row(), 1));
  return replanning;
}

/// A change that has made this cell an obstacle: is it a reason?
bool obstacle_is_reason(Replanning& replanning, std::uint64_t version, int x, int y) {
  return replanning.change({version, box(x, y)}, space_with({x, y}), {});
}

TEST(Replanning, IsForChangesAhead) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  EXPECT_FALSE(obstacle_is_reason(replanning, 2, 10, 9));
  EXPECT_TRUE(obstacle_is_reason(replanning, 3, 10, 5));
}

TEST(Replanning, IsForEveryChangeOrForNoneIfToldSo) {
  Replanning always = planned(ReplanOnChange::always);
  EXPECT_TRUE(obstacle_is_reason(always, 2, 10, 9));
  EXPECT_FALSE(always.change({3, {}}, space_with({1, 1}), {})) << "nothing has changed";
  Replanning never = planned(ReplanOnChange::never);
  EXPECT_FALSE(obstacle_is_reason(never, 2, 10, 5));
  EXPECT_FALSE(never.change({3, SpaceChange::of_everything()}, space_with({10, 5}), {}));
}

TEST(Replanning, IsForEveryChangeWhileThereIsNoPath) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  replanning.begin();
  EXPECT_FALSE(replanning.end({}, 2));
  EXPECT_TRUE(obstacle_is_reason(replanning, 3, 20, 20)) << "it may have opened a way";
}

TEST(Replanning, AChangeDuringASearchCountsAtItsEnd) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  replanning.begin();
  EXPECT_FALSE(obstacle_is_reason(replanning, 2, 10, 5)) << "the search may find another path";
  EXPECT_FALSE(replanning.end(Path::along({{0.5, 9.5}, {20.5, 9.5}}), 1)) << "it did";
  replanning.begin();
  EXPECT_FALSE(obstacle_is_reason(replanning, 3, 10, 9));
  EXPECT_TRUE(replanning.end(Path::along({{0.5, 9.5}, {20.5, 9.5}}), 2));
}

TEST(Replanning, WhatTheSearchKnewAlreadyDoesNotCount) {
  Replanning replanning = planned(ReplanOnChange::ahead);
  replanning.begin();
  EXPECT_FALSE(obstacle_is_reason(replanning, 2, 10, 5));
  EXPECT_FALSE(replanning.end(along_a_row(), 2)) << "it planned on version 2";
  EXPECT_FALSE(obstacle_is_reason(replanning, 2, 10, 5)) << "the news of it came late";
  EXPECT_TRUE(obstacle_is_reason(replanning, 3, 10, 5));
}

}  // namespace
}  // namespace wend_ros
