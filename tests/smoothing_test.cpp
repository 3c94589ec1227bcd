// Smoothers and what they guarantee, on thousands of random maps: the paths are A*'s, for points and
// discs, with every corner rule. What they give back is checked at many points by a robot that shares
// no code with the sweeps that kept it free.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/random_path.hpp"
#include "tests/testing/sampled_robot.hpp"
#include "tests/testing/share.hpp"
#include "tests/testing/smoothing_objective.hpp"
#include "wend/generate/generators.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/smoothing/curvature_smoother.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend {
namespace {

/// A map, a robot and a path of A* on it.
struct Trial {
  GridMap map;
  double radius = 0;  // cells
  Adjacency adjacency = Adjacency::edges;
  FreeSpace space;
  Path path;
};

std::optional<Trial> random_trial(Random& random) {
  const int most = test::one_of<int>(random, std::array{6, 12, 24, 40});
  const GridMap map = test::random_map(random, random.between(2, most), random.between(2, most));
  const double radius =
      test::one_of<double>(random, std::array{0.0, 0.0, 0.0, 0.3, 0.5, 1.0, 1.7, 2.7});
  const FreeSpace space =
      *make_free_space(map, {.footprint = Footprint::disc(radius * map.frame().resolution)});
  const std::string rule =
      test::one_of<std::string>(random, std::array<std::string, 3>{"none", "one", "both"});
  const auto planner = make_planner("astar", space, {{"corner_rule", rule}});
  // The farthest of a few test_queries that can be done.
  Path longest;
  for (int i = 0; i < 6; ++i) {
    const auto plan =
        (*planner)->plan(Query::between(test::random_cell(random, map.width(), map.height()),
                                        test::random_cell(random, map.width(), map.height())));
    if (plan && plan->path.size() > longest.size()) longest = plan->path;
  }
  if (longest.empty()) return std::nullopt;
  return Trial{map, radius, rule == "both" ? Adjacency::edges_and_corners : Adjacency::edges, space,
               longest};
}

template <class Check>
void on_random_plans(std::uint64_t trials, Check&& check) {
  for (std::uint64_t seed = 1; seed <= test::share_of(trials) && !::testing::Test::HasFailure();
       ++seed) {
    Random random(seed);
    const auto trial = random_trial(random);
    if (!trial) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " + std::to_string(trial->radius) +
                 "\n" + test::drawing_of(trial->map) + test::text_of(trial->path));
    check(*trial, random);
  }
}

/// Walks along a path in small steps. Where a point goes from one free cell to another at a corner,
/// one of the two cells beside must be free too, unless it may squeeze.
void expect_sampled_free(const Path& path, const Trial& trial) {
  constexpr double kStep = 0.02;
  const test::SampledRobot robot(trial.map, trial.radius,
                                 trial.space.outside() == OutsidePolicy::blocked);
  const bool may_squeeze = trial.adjacency == Adjacency::edges_and_corners || trial.radius > 0;
  std::optional<Cell> last;
  const auto points = path.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point from = points[i == 0 ? 0 : i - 1];
    const int steps = 1 + static_cast<int>(distance(from, points[i]) / kStep);
    for (int k = 1; k <= steps; ++k) {
      const double share = k / static_cast<double>(steps);
      const Point at{from.x + share * (points[i].x - from.x),
                     from.y + share * (points[i].y - from.y)};
      ASSERT_FALSE(robot.collides_at(at)) << at.x << "," << at.y;
      const Cell cell = cell_at(at);
      if (robot.is_obstacle(cell.x, cell.y)) continue;  // on its edge
      if (last && !may_squeeze && last->x != cell.x && last->y != cell.y) {
        ASSERT_FALSE(robot.is_obstacle(last->x, cell.y) && robot.is_obstacle(cell.x, last->y))
            << "between two obstacles at " << at.x << "," << at.y;
      }
      last = cell;
    }
  }
}

/// What is true of every safe smoother.
void expect_guarantee_kept(const Smoothed& smoothed, const Trial& trial) {
  const auto points = smoothed.path.points();
  ASSERT_GE(points.size(), trial.path.size());
  ASSERT_EQ(points.front(), trial.path.points().front());
  ASSERT_EQ(points.back(), trial.path.points().back());
  ASSERT_LE(smoothed.path.length(), trial.path.length() + 1e-9);
  ASSERT_FALSE(first_collision(smoothed.path, trial.space, trial.adjacency));
  ASSERT_GE(smoothed.held, 0);
  ASSERT_LE(smoothed.held, 1);
  expect_sampled_free(smoothed.path, trial);
}

OptionValues squeezing(const Trial& trial) {
  return {{"squeeze", trial.adjacency == Adjacency::edges_and_corners ? "true" : "false"}};
}

/// On an office with cells of 0.1 m; from anywhere to anywhere, but not just around the corner.
std::vector<Path> office_plans(const FreeSpace& space, Random& random, int count) {
  const auto planner = make_planner("astar", space);
  std::vector<Path> plans;
  while (static_cast<int>(plans.size()) < count) {
    const auto cell = [&] {
      return *nearest_passable(space, test::random_cell(random, space.width(), space.height()));
    };
    const auto plan = (*planner)->plan(Query::between(cell(), cell()));
    if (plan && plan->path.size() > 40) plans.push_back(plan->path);
  }
  return plans;
}

TEST(Smoothing, BoundsCurvatureInOffices) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const auto map = make_map("office", 200, 160, seed);
    const FreeSpace space = *make_free_space(*map, {.footprint = Footprint::disc(0.2)});
    for (const Path& path : office_plans(space, random, 4)) {
      for (const double radius : {3.0, 4.0}) {
        const auto smoothed = smooth_by_curvature(path, space, {.radius = radius});
        ASSERT_TRUE(smoothed);
        EXPECT_TRUE(smoothed->within_bound) << "seed " << seed << ", radius " << radius;
        EXPECT_GE(measure(smoothed->path, space)->rounded_turning_radius, radius * (1 - 1e-5));
        EXPECT_FALSE(first_collision(smoothed->path, space));
      }
    }
  }
}

/// What docs/motion.md says of turning radii in offices.
TEST(Smoothing, MeetsTurningRadiiThatDoorsAllow) {
  for (const auto& [radius, least] : {std::pair(3.0, 1.0), {4.0, 1.0}, {5.0, 0.95}, {10.0, 0.2}}) {
    int met = 0;
    int plans = 0;
    for (std::uint64_t seed = 1; seed <= test::share_of(4U); ++seed) {
      Random random(seed);
      const auto map = make_map("office", 200, 160, seed);
      const FreeSpace space = *make_free_space(*map, {.footprint = Footprint::disc(0.2)});
      for (const Path& path : office_plans(space, random, 25)) {
        met += smooth_by_curvature(path, space, {.radius = radius})->within_bound ? 1 : 0;
        ++plans;
      }
    }
    std::cout << "a turning radius of " << radius << " cells: met on " << met << " of " << plans
              << " plans\n";
    EXPECT_GE(met, least * plans);
  }
}

/// Weights that converge, often ones that draw the path hard against the obstacles.
GradientOptions random_weights(Random& random, const Trial& trial) {
  GradientOptions options;
  options.squeeze = trial.adjacency == Adjacency::edges_and_corners;
  options.in_place = random.chance(0.5);
  options.alpha = test::one_of<double>(random, std::array{0.0, 0.01, 0.1, 0.5});
  const double most = (2 - options.alpha) / (options.in_place ? 2 : 4);
  options.beta = random.uniform() * std::min(most, 1.0);
  options.epsilon = test::one_of<double>(random, std::array{1e-3, 1e-3, 1e-9});
  options.max_sweeps = test::one_of<int>(random, std::array{1, 5, 200});
  return options;
}

TEST(Smoothing, IsSafeByGradientWhateverTheWeights) {
  int held = 0;
  int unheld = 0;
  int squeezing = 0;
  on_random_plans(3000, [&](const Trial& trial, Random& random) {
    const auto smoothed =
        smooth_by_gradient(trial.path, trial.space, random_weights(random, trial));
    ASSERT_TRUE(smoothed) << smoothed.error().message;
    expect_guarantee_kept(*smoothed, trial);
    ASSERT_EQ(smoothed->path.size(), trial.path.size());
    if (trial.path.size() > 2) ++(smoothed->held > 0 ? held : unheld);
    squeezing += first_collision(smoothed->path, trial.space) ? 1 : 0;
  });
  EXPECT_GT(held, test::share_of(300));
  EXPECT_GT(unheld, test::share_of(300));
  EXPECT_GT(squeezing, test::share_of(30)) << "through gaps, where it may";
}

TEST(Smoothing, IsSafeWithEverySmootherAsItComes) {
  on_random_plans(500, [&](const Trial& trial, Random&) {
    for (const SmootherInfo& smoother : smoothers()) {
      if (smoother.drives) continue;  // wend/path/smoothing/drive_smoother_test.cpp
      SCOPED_TRACE(smoother.name);
      const auto smoothed = smoother.make(squeezing(trial)).value()(trial.path, trial.space);
      ASSERT_TRUE(smoothed) << smoothed.error().message;
      expect_guarantee_kept(*smoothed, trial);
    }
  });
}

/// Moves that are cut or left out do not make it grow either.
TEST(Smoothing, LetsTheObjectiveOnlyFall) {
  int held = 0;
  on_random_plans(1000, [&](const Trial& trial, Random& random) {
    GradientOptions options = random_weights(random, trial);
    options.epsilon = 0;
    double last = smoothing_objective(trial.path, trial.path, options);
    for (const int sweeps : {1, 2, 3, 4, 5, 8, 13}) {
      options.max_sweeps = sweeps;
      const auto smoothed = smooth_by_gradient(trial.path, trial.space, options);
      if (smoothed->returned) return;
      held += smoothed->held > 0 ? 1 : 0;
      const double objective = smoothing_objective(trial.path, smoothed->path, options);
      ASSERT_LE(objective, last * (1 + 1e-12)) << sweeps << " sweeps";
      last = objective;
    }
  });
  EXPECT_GT(held, test::share_of(500));
}

TEST(Smoothing, StaysSafeBetweenSimplifyingAndResampling) {
  on_random_plans(1500, [&](const Trial& trial, Random& random) {
    Refinement refinement{.adjacency = trial.adjacency};
    if (random.chance(0.7)) {
      refinement.simplify = Simplification{
          test::one_of<SimplifyBy>(
              random, std::array{SimplifyBy::collinear, SimplifyBy::tolerance, SimplifyBy::sight}),
          random.uniform() * 2};
    }
    if (random.chance(0.8)) refinement.smoother = SmootherChoice{};
    if (random.chance(0.7)) refinement.spacing = 0.2 + random.uniform() * 3;
    const auto all = refined(trial.path, trial.space, refinement);
    ASSERT_TRUE(all) << all.error().message;
    ASSERT_EQ(all->path.points().front(), trial.path.points().front());
    ASSERT_EQ(all->path.points().back(), trial.path.points().back());
    ASSERT_LE(all->path.length(), trial.path.length() + 1e-9);
    ASSERT_FALSE(first_collision(all->path, trial.space, trial.adjacency));
    expect_sampled_free(all->path, trial);
  });
}

/// What the reference does on the same plans: the safety is not for nothing.
TEST(Smoothing, CollidesOftenWhereItIsToldToBeUnsafe) {
  int colliding = 0;
  int plans = 0;
  on_random_plans(1000, [&](const Trial& trial, Random&) {
    const auto smoothed = smooth_by_gradient(trial.path, trial.space, {.unsafe = true});
    ASSERT_EQ(smoothed->held, 0);
    ++plans;
    colliding += first_collision(smoothed->path, trial.space, trial.adjacency) ? 1 : 0;
  });
  EXPECT_GT(colliding, plans / 10);
}

}  // namespace
}  // namespace wend
