#include "wend/path/path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/direction.hpp"

namespace wend {
namespace {

/// A walk to neighbouring cells.
std::vector<Cell> any_walk(int steps) {
  std::vector<Cell> cells{{*rc::gen::inRange(-50, 50), *rc::gen::inRange(-50, 50)}};
  for (int i = 0; i < steps; ++i) {
    const auto direction = static_cast<Direction>(*rc::gen::inRange(0, kDirections));
    cells.push_back(step(cells.back(), direction));
  }
  return cells;
}

RC_GTEST_PROP(Path, LengthIsTheSumOfItsSteps, ()) {
  const std::vector<Cell> cells = any_walk(*rc::gen::inRange(0, 60));
  double sum = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    sum += std::hypot(cells[i].x - cells[i - 1].x, cells[i].y - cells[i - 1].y);
  }
  RC_ASSERT(std::abs(Path(cells).length() - sum) < 1e-12 * (1 + sum));
}

RC_GTEST_PROP(Path, LengthIsTheSameBackwards, ()) {
  Path path(any_walk(*rc::gen::inRange(0, 60)));
  const double forwards = path.length();
  path.reverse();
  RC_ASSERT(path.length() == forwards);
}

TEST(Path, LengthCountsStepsExactly) {
  // Added up one by one these would differ in the last digits from what is expected here.
  std::vector<Cell> cells{{0, 0}};
  for (int i = 1; i <= 1000; ++i) cells.push_back({i, i});
  for (int i = 1; i <= 10; ++i) cells.push_back({1000 + i, 1000});
  EXPECT_EQ(Path(cells).length(), 10 + 1000 * std::numbers::sqrt2);
}

TEST(Path, IsOfStepsIfItsCellsAreNeighbours) {
  EXPECT_TRUE(Path({{3, 3}}).of_steps());
  EXPECT_TRUE(Path({{3, 3}, {4, 3}, {5, 2}}).of_steps());
  EXPECT_FALSE(Path({{3, 3}, {4, 3}, {6, 3}}).of_steps());
  EXPECT_FALSE(Path().of_steps());
  EXPECT_FALSE(Path::along({{0.5, 0.5}, {1.5, 0.5}}).of_steps());
}

TEST(Path, LengthOfFartherCellsIsTheirDistance) {
  EXPECT_DOUBLE_EQ(Path({{0, 0}, {3, 4}, {3, 4}, {3, 5}}).length(), 6);
  EXPECT_EQ(Path({{7, 7}}).length(), 0);
  EXPECT_EQ(Path().length(), 0);
}

RC_GTEST_PROP(Path, PosesAreCellCentresThatHeadForTheNextOne, ()) {
  const std::vector<Cell> cells = any_walk(*rc::gen::inRange(1, 40));
  const std::vector<Pose> poses = Path(cells).poses();
  RC_ASSERT(poses.size() == cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    RC_ASSERT(poses[i].point() == (Point{cells[i].x + 0.5, cells[i].y + 0.5}));
    if (i + 1 == cells.size()) continue;
    const double far = distance(poses[i].point(), poses[i + 1].point());
    RC_ASSERT(std::abs(poses[i].x + far * std::cos(poses[i].heading) - poses[i + 1].x) < 1e-12);
    RC_ASSERT(std::abs(poses[i].y + far * std::sin(poses[i].heading) - poses[i + 1].y) < 1e-12);
  }
  RC_ASSERT(poses.back().heading == poses[poses.size() - 2].heading);
}

TEST(Path, ASinglePoseHeadsAlongX) {
  EXPECT_EQ(Path({{3, 4}}).poses(), (std::vector<Pose>{{3.5, 4.5, 0}}));
  EXPECT_TRUE(Path().poses().empty());
}

TEST(Path, StandingStillKeepsTheHeading) {
  const auto poses = Path({{0, 0}, {0, 1}, {0, 1}, {1, 1}}).poses();
  EXPECT_DOUBLE_EQ(poses[0].heading, kPi / 2);
  EXPECT_DOUBLE_EQ(poses[1].heading, kPi / 2);
  EXPECT_DOUBLE_EQ(poses[2].heading, 0);
}

TEST(Path, PointsInMetresAreCellCentresInTheMapsFrame) {
  const Path path({{0, 0}, {1, 1}, {2, 1}});
  // Where y is drawn makes no difference to metres: the frame's origin is a corner of cell (0, 0).
  for (const bool y_up : {false, true}) {
    const Frame frame{.resolution = 0.5, .origin = {-1, 2, 0}, .y_up = y_up, .metric = true};
    EXPECT_EQ(path.points_in_metres(frame),
              (std::vector<MapPoint>{{-0.75, 2.25}, {-0.25, 2.75}, {0.25, 2.75}}));
  }
}

TEST(Path, PointsInMetresTurnByTheYaw) {
  const Frame frame{.resolution = 2, .origin = {10, 0, kPi / 2}, .y_up = true, .metric = true};
  const auto points = Path({{0, 0}, {1, 0}}).points_in_metres(frame);
  EXPECT_NEAR(points[0].x, 9, 1e-12);
  EXPECT_NEAR(points[0].y, 1, 1e-12);
  EXPECT_NEAR(points[1].x, 9, 1e-12);
  EXPECT_NEAR(points[1].y, 3, 1e-12);
}

TEST(Path, IsWrittenCellByCell) {
  Path path;
  EXPECT_TRUE(path.empty());
  path.append({1, 1});
  path.append({2, 1});
  path.reverse();
  EXPECT_EQ(path, Path({{2, 1}, {1, 1}}));
  EXPECT_EQ(path.size(), 2U);
  EXPECT_EQ(path.cells().front(), (Cell{2, 1}));
  path.clear();
  EXPECT_TRUE(path.empty());
}

TEST(Path, BecomesOfAnotherKindOnceItIsEmpty) {
  Path path = Path::along({{1, 2}, {3, 4}});
  path.reverse();
  EXPECT_EQ(path, Path::along({{3, 4}, {1, 2}}));
  EXPECT_NE(path, Path({{3, 4}, {1, 2}}));
  path.clear();
  EXPECT_EQ(path, Path()) << "an empty path has no kind";
  EXPECT_TRUE(
      path.visit([](std::span<const Cell>) { return true; }, [](const auto&) { return false; }));
  path.drive_to({1, 1, 0});
  EXPECT_EQ(path, Path::through({{1, 1, 0}}));
  path.clear();
  path.make_cells(1)[0] = {2, 3};
  EXPECT_EQ(path, Path({{2, 3}}));
  EXPECT_TRUE(path.driven_poses().empty() && path.waypoints().empty());
}

TEST(DrivenPath, IsMadeOfPosesAndArcs) {
  const Path path = Path::through({{0, 0, 0}, {1, 1, kPi / 2}, {1, 0, kPi / 2}});
  EXPECT_TRUE(path.driven());
  EXPECT_EQ(path.size(), 3U);
  EXPECT_TRUE(path.cells().empty());
  EXPECT_THAT(path.driven_poses(), ::testing::ElementsAreArray(path.poses()));
  EXPECT_EQ(path.driven_poses().size(), 3U);
  EXPECT_TRUE(Path({{1, 1}}).driven_poses().empty());
  ASSERT_EQ(path.arcs().size(), 2U);
  EXPECT_NEAR(path.arcs()[0].turn(), kPi / 2, 1e-15);
  EXPECT_NEAR(path.arcs()[1].length, -1, 1e-15);
  EXPECT_NEAR(path.length(), kPi / 2 + 1, 1e-15);
  Frame frame;
  frame.resolution = 0.5;
  EXPECT_EQ(path.points_in_metres(frame), (std::vector<MapPoint>{{0, 0}, {0.5, 0.5}, {0.5, 0}}));
}

TEST(DrivenPath, IsWrittenIntoMemoryThatIsKept) {
  Path path;
  EXPECT_FALSE(path.driven());
  path.drive_to({1, 1, 0});
  path.drive_to({0, 1, 0});
  EXPECT_FALSE(path.empty());
  path.reverse();
  EXPECT_EQ(path, Path::through({{0, 1, 0}, {1, 1, 0}}));
  path.clear();
  EXPECT_TRUE(path.empty());
}

RC_GTEST_PROP(Path, ArcsJoinPosesWhateverItIsMadeOf, ()) {
  const std::vector<Cell> cells = any_walk(*rc::gen::inRange(1, 40));
  const Path of_cells(cells);
  const Path of_waypoints = Path::along(of_cells.points());
  for (const Path& path : {of_cells, of_waypoints}) {
    const std::vector<Pose> poses = path.poses();
    const std::vector<Arc> arcs = path.arcs();
    RC_ASSERT(arcs.size() + 1 == poses.size());
    double length = 0;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      RC_ASSERT(distance(end_of(arcs[i]).point(), poses[i + 1].point()) < 1e-12);
      length += arcs[i].length;
    }
    RC_ASSERT(std::abs(length - path.length()) < 1e-9 * (1 + length));
  }
}

TEST(Path, OfWaypointsKeepsThem) {
  Path path = Path::along({{0.25, 1}, {3.25, 5}, {3.25, 6}});
  EXPECT_EQ(path.size(), 3U);
  EXPECT_FALSE(path.driven());
  EXPECT_FALSE(path.empty());
  EXPECT_TRUE(path.cells().empty());
  EXPECT_DOUBLE_EQ(path.length(), 6);
  EXPECT_EQ(path.poses()[1], (Pose{3.25, 5, kPi / 2}));
  path.reverse();
  EXPECT_EQ(path, Path::along({{3.25, 6}, {3.25, 5}, {0.25, 1}}));
  path.clear();
  EXPECT_TRUE(path.empty());
}

std::string kind_of(const Path& path) {
  return path.visit(
      [](std::span<const Cell> cells) { return std::to_string(cells.size()) + " cells"; },
      [](std::span<const Point> points) { return std::to_string(points.size()) + " waypoints"; },
      [](const JoinedPoses& joined) {
        return std::to_string(joined.segment_count()) + " segments";
      });
}

TEST(Path, IsVisitedAsWhatItIsMadeOf) {
  EXPECT_EQ(kind_of(Path({Cell{1, 1}, Cell{2, 1}})), "2 cells");
  EXPECT_EQ(kind_of(Path::along({{0, 0}})), "1 waypoints");
  EXPECT_EQ(kind_of(Path::through({{0, 0, 0}, {1, 1, kPi / 2}, {1, 1, 0}})), "2 segments");
  EXPECT_EQ(kind_of(Path()), "0 cells");
}

TEST(Path, JoinsPosesByTheSegmentsThatItLists) {
  const Path path = Path::through({{0, 0, 0}, {1, 1, kPi / 2}, {1, 1, 0}, {1, 3, 0}});
  const auto segments = path.segments();
  path.visit(
      [&](const JoinedPoses& joined) {
        ASSERT_EQ(joined.segment_count(), segments.size());
        for (std::size_t i = 0; i < segments.size(); ++i) {
          const Segment segment = joined.segment(i);
          EXPECT_EQ(segment.from, joined.poses()[i]);
          EXPECT_EQ(segment.length, segments[i].length);
          EXPECT_EQ(segment.turn, segments[i].turn);
          EXPECT_EQ(segment.course, segments[i].course);
        }
      },
      [](const auto&) { FAIL() << "it has poses"; });
}

}  // namespace
}  // namespace wend
