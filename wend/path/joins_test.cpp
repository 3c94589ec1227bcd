#include "wend/path/joins.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/trajectory.hpp"

namespace wend {
namespace {

/// A path of each kind with that many points.
std::vector<Path> paths_of(std::size_t points) {
  std::vector<Cell> cells;
  std::vector<Point> waypoints;
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < points; ++i) {
    const int x = static_cast<int>(i);
    cells.push_back({x, x % 2});
    waypoints.push_back({x + 0.25, 0.5});
    poses.push_back({x + 0.5, 0.5, 0});
  }
  return {Path(cells), Path::along(waypoints), Path::over_cells(waypoints), Path::through(poses)};
}

RC_GTEST_PROP(Joins, DivideAPathIntoLegsThatMakeItAgain, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 12);
  auto joins =
      *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, size));
  std::ranges::sort(joins);
  for (const Path& path : paths_of(size)) {
    RC_ASSERT(!fault_of_joins(joins, size));
    const std::vector<Path> legs = legs_between(path, joins);
    RC_ASSERT(legs.size() == joins.size() + 1);
    const Path again = end_to_end(legs);
    RC_ASSERT(again == path);
    RC_ASSERT(again.leads_over_cells() == path.leads_over_cells());
    for (std::size_t i = 0; i < joins.size(); ++i) {
      RC_ASSERT(legs[i].points().back() == path.points()[joins[i]]);
      RC_ASSERT(legs[i + 1].points().front() == path.points()[joins[i]]);
    }
  }
}

TEST(Joins, OfCellsAndWaypointsAreWaypoints) {
  const std::array legs{Path({{0, 0}, {1, 0}}), Path::over_cells({{1.5, 0.5}, {2.25, 0.5}})};
  const Path whole = end_to_end(legs);
  EXPECT_EQ(whole, Path::over_cells({{0.5, 0.5}, {1.5, 0.5}, {2.25, 0.5}}));
  EXPECT_TRUE(whole.leads_over_cells());
}

TEST(Joins, AreRefusedOutOfOrderAndBeyondThePath) {
  for (const auto& joins : {std::vector<std::size_t>{3, 2}, {5}, {0, 1, 7}}) {
    const auto fault = fault_of_joins(joins, 5);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->status, Status::invalid_option);
    EXPECT_EQ(fault->where, "joins");
  }
  const auto refused = refined(Path({{0, 0}, {1, 0}}), test::open_space(4, 4), {.joins = {2}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "joins");
}

/// Whatever is done with the legs, their ends stay, and the whole is free.
TEST(Joins, StayWhereTheyAreWhenAPathIsRefined) {
  const FreeSpace space = test::drawn_space(
      "..........\n"
      ".....#....\n"
      ".....#....\n"
      "..........\n");
  const Path path({{0, 0},
                   {1, 0},
                   {2, 0},
                   {3, 0},
                   {4, 0},
                   {5, 0},
                   {6, 0},
                   {7, 1},
                   {8, 2},
                   {9, 3},
                   {8, 3},
                   {7, 3},
                   {6, 3}});
  for (const bool simplify : {false, true}) {
    for (const char* const smoother : {"", "gradient", "curvature"}) {
      for (const double spacing : {0.0, 0.3}) {
        Refinement refinement{.joins = {4, 4, 9}};
        if (simplify) refinement.simplify = Simplification{};
        if (*smoother != '\0') refinement.smoother = SmootherChoice{smoother, {}};
        if (spacing > 0) refinement.spacing = spacing;
        const auto result = refined(path, space, refinement);
        ASSERT_TRUE(result) << result.error().message;
        ASSERT_EQ(result->joins.size(), 3U);
        const std::vector<Point> points = result->path.points();
        EXPECT_EQ(points[result->joins[0]], (Point{4.5, 0.5}));
        EXPECT_EQ(points[result->joins[1]], (Point{4.5, 0.5}));
        EXPECT_EQ(points[result->joins[2]], (Point{9.5, 3.5}));
        EXPECT_FALSE(first_collision(result->path, space));
      }
    }
  }
}

TEST(TrajectoriesInARow, AreEachFromRestToRest) {
  const auto along = [](Point from, Point to) {
    return *Trajectory::along(Path::along({from, to}), Frame{});
  };
  const std::array legs{along({0, 0}, {4, 0}), along({4, 0}, {9, 0})};
  const Trajectory whole = Trajectory::in_a_row(legs);
  EXPECT_EQ(whole.duration(), legs[0].duration() + legs[1].duration());
  EXPECT_EQ(whole.length(), 9);
  EXPECT_NEAR(whole.at(legs[0].duration()).speed, 0, 1e-9);
  EXPECT_NEAR(whole.at(legs[0].duration()).pose.x, 4, 1e-9);
  EXPECT_EQ(whole.at(whole.duration()).pose.x, 9);
  for (const double share : {0.2, 0.7}) {
    const double time = share * legs[1].duration();
    EXPECT_NEAR(whole.at(legs[0].duration() + time).pose.x, legs[1].at(time).pose.x, 1e-9);
  }
}

}  // namespace
}  // namespace wend
