// Planners over poses on maps with directions: their drives lead against no arrow, and their estimates are right.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "conformance/random_directions.hpp"
#include "conformance/trial.hpp"
#include "tests/testing/share.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

/// How far a drive leads against arrows at one go, in cells, by points 1/64 cell apart.
double longest_against(const Path& path, const GridMap& map) {
  constexpr int kPoints = 64;  // in a cell
  double run = 0;
  double longest = 0;
  for (const Segment& segment : path.segments()) {
    if (segment.length == 0) continue;
    const int parts = 1 + static_cast<int>(std::abs(segment.length) * kPoints);
    for (int i = 0; i < parts; ++i) {
      const Point from = pose_on(segment, static_cast<double>(i) / parts).point();
      const Point to = pose_on(segment, (i + 1.0) / parts).point();
      const Cell cell = cell_at(Point{(from.x + to.x) / 2, (from.y + to.y) / 2});
      const double heading = std::atan2(to.y - from.y, to.x - from.x);
      // The chord differs from the tangent by a little.
      constexpr double kLeeway = 0.02;
      bool against = map.contains(cell);
      for (const double off : {-kLeeway, 0.0, kLeeway}) {
        against = against && std::isinf(map.directions()->rule(cell).factor(heading + off));
      }
      run = against ? run + std::abs(segment.length) / parts : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

class DirectedDrives : public ::testing::TestWithParam<std::string> {
 protected:
  static Trial trial_of(std::uint64_t seed) {
    const PlannerInfo& info = *planners().find(GetParam());
    Trial trial = random_pose_trial(seed, info);
    trial.options.clear();
    Random random(seed);
    trial.map = with_random_directions(random, trial.map);
    return trial;
  }
};

TEST_P(DirectedDrives, LeadAgainstNoArrow) {
  const std::uint64_t maps =
      GetParam() == "hybrid_astar" ? share_of(std::uint64_t{12}) : share_of(std::uint64_t{300});
  int found = 0;
  for (std::uint64_t seed = 0; seed < maps; ++seed) {
    const Trial trial = trial_of(seed);
    SCOPED_TRACE(text_of(trial, seed));
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    const auto planner = make_planner(GetParam(), space);
    if (!planner) continue;  // no lattice fits
    Random random(seed);
    for (int i = 0; i < 3; ++i) {
      Query query = random_pose_query(random, trial.map);
      query.limits.expansions = 3000;
      const auto plan = (*planner)->plan(query);
      if (!plan) continue;
      ++found;
      EXPECT_LT(longest_against(plan->path, trial.map), 0.125 + 1.0 / 16);
      const auto collision = first_collision(plan->path, space);
      EXPECT_FALSE(collision) << (collision ? describe(collision->kind) : "");
    }
  }
  EXPECT_GT(found, static_cast<int>(maps / 6));
}

INSTANTIATE_TEST_SUITE_P(OverPoses, DirectedDrives,
                         ::testing::Values("car", "lattice", "hybrid_astar"),
                         [](const auto& test) { return test.param; });

class DirectedLattices : public DirectedDrives {};

TEST_P(DirectedLattices, FindTheSameCostWithAndWithoutAnEstimate) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < share_of(std::uint64_t{300}); ++seed) {
    const Trial trial = trial_of(seed);
    SCOPED_TRACE(text_of(trial, seed));
    const FreeSpace space = *make_free_space(trial.map, trial.robot);
    const auto guided = make_planner(GetParam(), space);
    const auto blind = make_planner(GetParam(), space, {{"weight", "0"}});
    if (!guided) continue;
    ASSERT_TRUE(blind);
    Random random(seed);
    const Query query = random_pose_query(random, trial.map);
    const auto plan = (*guided)->plan(query);
    const auto truth = (*blind)->plan(query);
    ASSERT_EQ(plan.has_value(), truth.has_value());
    if (!plan) continue;
    ++found;
    EXPECT_NEAR(plan->cost, truth->cost, 1e-9 * (1 + truth->cost));
  }
  EXPECT_GT(found, 20);
}

INSTANTIATE_TEST_SUITE_P(OverPoses, DirectedLattices, ::testing::Values("car", "lattice"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend::test
