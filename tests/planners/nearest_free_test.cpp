// Planner::nearest_free() against all vertices of random maps, each tried by a query that starts there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "conformance/trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

class NearestFree : public ::testing::TestWithParam<std::string> {};

/// Does a query that starts there get as far as a search, or to its goal?
bool starts_at(Planner& planner, const Pose& pose) {
  Query query{pose, {Goal(pose)}};
  query.limits.expansions = 0;
  Plan plan;
  const Status status = planner.plan(query, plan);
  return status != Status::start_blocked && status != Status::start_outside;
}

/// The vertex (a corner, or the middle of a cell) nearest to a point, on the map or not.
Point vertex_near(Point point, bool corners) {
  const double offset = corners ? 0 : 0.5;
  return {std::round(point.x - offset) + offset, std::round(point.y - offset) + offset};
}

TEST_P(NearestFree, IsTheNearestPlaceWhereAQueryCanStart) {
  const PlannerInfo& info = *planners().find(GetParam());
  const bool corners = info.capabilities.vertices == Vertices::corners;
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= share_of(400U) && !HasFailure(); ++seed) {
    const Trial trial = random_pose_trial(seed, info);
    SCOPED_TRACE(text_of(trial, seed));
    const auto planner =
        make_planner(GetParam(), *make_free_space(trial.map, trial.robot), trial.options);
    if (!planner) continue;
    Random random(seed);
    const Pose asked = random_pose_query(random, trial.map).start;
    const auto found = (*planner)->nearest_free(Goal(asked));
    if (starts_at(**planner, asked)) {
      EXPECT_EQ(found, asked.point());
      continue;
    }
    const Point from = vertex_near(asked.point(), corners);
    double least = std::numeric_limits<double>::infinity();
    const int more = corners ? 1 : 0;
    for (int y = 0; y < trial.map.height() + more; ++y) {
      for (int x = 0; x < trial.map.width() + more; ++x) {
        const Point vertex{x + (corners ? 0 : 0.5), y + (corners ? 0 : 0.5)};
        if (!starts_at(**planner, {vertex.x, vertex.y, asked.heading})) continue;
        least = std::min(least, distance(from, vertex));
      }
    }
    ASSERT_EQ(found.has_value(), std::isfinite(least));
    if (!found) continue;
    EXPECT_TRUE(starts_at(**planner, {found->x, found->y, asked.heading}));
    EXPECT_EQ(distance(from, *found), least);
    ++moved;
  }
  EXPECT_GT(moved, share_of(20));
}

TEST_P(NearestFree, LeavesAGoalWithAFreePlaceWithinItsTolerance) {
  Grid<CellState> cells(9, 9, CellState::free);
  cells[{4, 4}] = CellState::occupied;
  const auto planner = make_planner(GetParam(), *make_free_space(*make_grid_map(cells)));
  const Point blocked{4.5, 4.5};
  EXPECT_EQ((*planner)->nearest_free(Goal(blocked, 3)), blocked);
  EXPECT_NE((*planner)->nearest_free(Goal(blocked)), blocked);
}

TEST_P(NearestFree, HasNothingForAPoseThatIsNotFinite) {
  const auto planner = make_planner(
      GetParam(), *make_free_space(*make_grid_map(Grid<CellState>(4, 4, CellState::free))));
  EXPECT_FALSE((*planner)->nearest_free(Goal(Pose{std::nan(""), 1, 0})));
  EXPECT_FALSE((*planner)->nearest_free(Goal(Pose{1, 1, std::nan("")})));
  EXPECT_FALSE((*planner)->nearest_free(Goal(Pose{1e300, 1, 0})));
}

INSTANTIATE_TEST_SUITE_P(Registry, NearestFree, ::testing::Values("car", "lattice"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
