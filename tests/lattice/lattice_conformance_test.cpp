// The planner lattice against Dijkstra's algorithm over a map of states, with primitives, sweeps and costs
// of the test's own: fits_along() instead of swept cells, lengths of segments instead of steps.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/primitive_distances.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/map/own_costs.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

struct LatticeTrial {
  FreeSpace space;
  FreeSpace grown;  // for a robot that is a little larger
  double radius;    // turning circle
  double reverse_factor;
  Query query;
};

/// A box around the base point.
Footprint box_footprint(double ahead, double behind, double side, double grown) {
  return *Footprint::polygon(*Polygon::make({{ahead + grown, side + grown},
                                             {-behind - grown, side + grown},
                                             {-behind - grown, -side - grown},
                                             {ahead + grown, -side - grown}}));
}

LatticeTrial random_lattice_trial(std::uint64_t seed) {
  Random random(seed);
  const int width = random.between(6, 14);
  const int height = random.between(6, 14);
  Grid<CellState> cells(width, height, CellState::free);
  const double share = 0.3 * random.uniform() * random.uniform();
  for (const Cell cell : every_cell(cells)) {
    if (random.chance(share)) cells[cell] = CellState::occupied;
  }
  Footprint robot;
  Footprint larger = Footprint::disc(1e-6);
  const std::uint64_t kind = random.below(3);
  if (kind == 1) {
    robot = larger = Footprint::disc(0.3 + random.uniform());
  } else if (kind == 2) {
    const double ahead = 0.2 + 1.3 * random.uniform();
    const double behind = 0.7 * random.uniform();
    const double side = 0.2 + 0.5 * random.uniform();
    robot = box_footprint(ahead, behind, side, 0);
    larger = box_footprint(ahead, behind, side, 0.1);
  }
  const GridMap map = *make_grid_map(cells);
  const OutsidePolicy outside = random.chance(0.5) ? OutsidePolicy::blocked : OutsidePolicy::free;
  const auto pose = [&] {
    return Pose{random.uniform() * width, random.uniform() * height, 6.2 * random.uniform() - 3.1};
  };
  const double radius = random.below(3) == 0 ? 0 : 0.5 + 2.5 * random.uniform();
  Query query{pose(), {}};
  query.goals.emplace_back(pose());
  if (random.chance(0.3)) query.goals.emplace_back(pose().point());
  for (Goal& goal : query.goals) {
    if (random.chance(0.3)) goal.tolerance = 3 * random.uniform();
    if (random.chance(0.3)) goal.heading_tolerance = 3 * random.uniform();
  }
  return {*make_free_space(map, {.footprint = robot, .outside = outside}),
          *make_free_space(map, {.footprint = larger, .outside = outside}), radius,
          random.chance(0.5) ? 1 : 2.5, query};
}

GridPose grid_pose_of(const Pose& pose, const MotionPrimitives& primitives) {
  return {cell_at(pose.point()), primitives.nearest_heading(pose.heading)};
}

/// May a path to this goal end at a pose of the lattice?
bool ends_at(const Goal& goal, const GridPose& end, const MotionPrimitives& primitives) {
  const double away = std::hypot(end.cell.x + 0.5 - goal.point.x, end.cell.y + 0.5 - goal.point.y);
  const bool here = cell_at(goal.point) == end.cell || away < goal.tolerance;
  if (!here || !goal.heading) return here;
  const double faced = primitives.headings()[static_cast<std::size_t>(end.heading)];
  const double turn = std::abs(std::remainder(faced - *goal.heading, 2 * std::numbers::pi));
  return primitives.nearest_heading(*goal.heading) == end.heading || turn < goal.heading_tolerance;
}

/// The least cost from the query's start to one of its goals that the robot can stand on.
double least_motion_cost(const LatticeTrial& trial, const FreeSpace& space,
                         const MotionPrimitives& primitives) {
  const PrimitiveDistances distances(space, primitives, trial.reverse_factor, 1);
  double least = kNoMotion;
  for (const auto& [state, cost] : distances.from(grid_pose_of(trial.query.start, primitives))) {
    for (const Goal& goal : trial.query.goals) {
      if (ends_at(goal, state, primitives)) least = std::min(least, cost);
    }
  }
  return least;
}

OptionValues lattice_options(const LatticeTrial& trial, const std::string& heuristic,
                             double weight) {
  return {{"turning_radius", format_number(trial.radius)},
          {"reverse_factor", format_number(trial.reverse_factor)},
          {"heuristic", heuristic},
          {"weight", format_number(weight)}};
}

/// Its segments one after the other: how much they cost.
double motion_cost(const Path& path, double reverse_factor) {
  double cost = 0;
  for (const Segment& segment : path.segments()) {
    if (segment.length == 0) cost += std::abs(segment.turn);
    cost += std::abs(segment.length) * (segment.length < 0 ? reverse_factor : 1);
  }
  return cost;
}

void expect_valid_motion(const Plan& plan, const LatticeTrial& trial,
                         const MotionPrimitives& primitives) {
  const auto poses = plan.path.driven_poses();
  ASSERT_FALSE(poses.empty());
  const GridPose first = grid_pose_of(trial.query.start, primitives);
  EXPECT_EQ(cell_at(poses.front().point()), first.cell);
  EXPECT_EQ(primitives.nearest_heading(poses.front().heading), first.heading);
  EXPECT_TRUE(std::ranges::any_of(trial.query.goals, [&](const Goal& goal) {
    return ends_at(goal, grid_pose_of(poses.back(), primitives), primitives);
  }));
  EXPECT_EQ(plan.moves.size() + 1, poses.size());
  EXPECT_NEAR(plan.cost, motion_cost(plan.path, trial.reverse_factor), 1e-9 * (1 + plan.cost));
  const auto collision = first_collision(plan.path, trial.space);
  EXPECT_FALSE(collision.has_value())
      << describe(collision->kind) << " at " << collision->point.x << "," << collision->point.y;
}

TEST(LatticeConformance, IsOptimalOnRandomMaps) {
  int found = 0;
  int unreachable = 0;
  for (std::uint64_t seed = 1; seed <= share_of(600U) && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const LatticeTrial trial = random_lattice_trial(seed);
    const MotionPrimitives primitives = *MotionPrimitives::turning_circle(trial.radius);
    const double least = least_motion_cost(trial, trial.space, primitives);
    const double most = least_motion_cost(trial, trial.grown, primitives);
    for (const std::string heuristic : {"zero", "distance", "obstacles"}) {
      for (const double weight : {1.0, 3.0}) {
        SCOPED_TRACE(heuristic + " " + format_number(weight));
        const auto planner =
            make_planner("lattice", trial.space, lattice_options(trial, heuristic, weight));
        ASSERT_TRUE(planner.has_value()) << planner.error().message;
        Plan plan;
        const Status status = (*planner)->plan(trial.query, plan);
        if (status == Status::found) {
          ++found;
          expect_valid_motion(plan, trial, primitives);
          EXPECT_GE(plan.cost, least - 1e-9);
          EXPECT_LE(plan.cost, weight * most + 1e-6);
        } else {
          ++unreachable;
          // A goal that the robot cannot reach may still be the cell where it stands.
          EXPECT_TRUE(std::isinf(most) || status == Status::start_blocked ||
                      status == Status::goal_blocked)
              << to_string(status) << ", there is a path of cost " << most;
          EXPECT_FALSE((*planner)->reason(trial.query, status).empty());
        }
      }
    }
  }
  EXPECT_GT(found, share_of(600));
  EXPECT_GT(unreachable, share_of(300));
}

TEST(LatticeConformance, AnswersASecondQueryLikeAFreshPlanner) {
  for (std::uint64_t seed = 1; seed <= share_of(100U); ++seed) {
    SCOPED_TRACE(seed);
    const LatticeTrial trial = random_lattice_trial(seed);
    const OptionValues options = lattice_options(trial, "obstacles", 1);
    const auto used = make_planner("lattice", trial.space, options);
    const auto fresh = make_planner("lattice", trial.space, options);
    Query other = trial.query;
    other.start.heading += 1;
    Plan first;
    Plan again;
    Plan alone;
    (*used)->plan(other, first);
    EXPECT_EQ((*used)->plan(trial.query, again), (*fresh)->plan(trial.query, alone));
    EXPECT_EQ(again.path, alone.path);
    EXPECT_EQ(again.cost, alone.cost);
    EXPECT_EQ(again.metrics.expanded, alone.metrics.expanded);
  }
}

TEST(LatticeConformance, PaysForTerrain) {
  const auto cost_on = [](std::string_view map) {
    const auto planner = make_planner("lattice", drawn_space(map));
    const auto plan = (*planner)->plan({Pose{0.5, 0.5, 0}, {Pose{4.5, 0.5, 0}}});
    return plan ? plan->cost : kNoMotion;
  };
  EXPECT_DOUBLE_EQ(cost_on("....."), 4);
  EXPECT_DOUBLE_EQ(cost_on("33333"), 12);
  EXPECT_DOUBLE_EQ(cost_on("..3.."), 6) << "one cell of four";
  EXPECT_LT(cost_on("..9..\n....."), 4 + 8) << "around it";
}

/// What a path costs on ground with costs.
struct GroundCost {
  double cost = 0;
  double doubt = 0;  // how far it can be off, because a sample lies on the border of cells
};

/// By 16 samples for each cell of a segment.
GroundCost cost_on_ground(const Path& path, const FreeSpace& space, double reverse_factor,
                          double most) {
  GroundCost sum;
  for (const Segment& segment : path.segments()) {
    const double length =
        segment.length == 0 ? std::abs(segment.turn)
                            : std::abs(segment.length) * (segment.length < 0 ? reverse_factor : 1);
    const int samples = 1 + static_cast<int>(16 * std::abs(segment.length));
    for (int n = 0; n < samples; ++n) {
      const Point at = pose_on(segment, (n + 0.5) / samples).point();
      sum.cost += length / samples * space.terrain(*cell_under(space, at));
    }
    sum.doubt += length / samples * (most - 1);
  }
  return sum;
}

TEST(LatticeConformance, SaysWhatItsPathCostsOnRandomCosts) {
  constexpr double kMost = 5;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= share_of(300U); ++seed) {
    SCOPED_TRACE(seed);
    const LatticeTrial trial = random_lattice_trial(seed);
    Random random(seed);
    const GridMap ground = *with_terrain(trial.space.map(), [&](Cell) {
      return random.chance(0.5) ? 1.0 : 1 + (kMost - 1) * random.uniform();
    });
    const FreeSpace space = *make_free_space(ground, trial.space.options());
    const auto planner = make_planner("lattice", space, lattice_options(trial, "obstacles", 1));
    Plan plan;
    if ((*planner)->plan(trial.query, plan) != Status::found) continue;
    ++found;
    const auto [cost, doubt] = cost_on_ground(plan.path, space, trial.reverse_factor, kMost);
    EXPECT_NEAR(plan.cost, cost, doubt + 1e-9);
    EXPECT_GE(plan.cost, motion_cost(plan.path, trial.reverse_factor) - 1e-9);
  }
  EXPECT_GT(found, share_of(100));
}

TEST(LatticeConformance, TurnsAPolygonOnlyWhereItFits) {
  // A robot of 3 x 1 cells in a corridor one and a half cells wide cannot turn round.
  const std::string_view corridor = ".....#.....\n...........\n.....#.....";
  FreeSpaceOptions options;
  options.footprint = box_footprint(1.5, 1.5, 0.45, 0);
  options.outside = OutsidePolicy::blocked;
  const auto planner = make_planner("lattice", drawn_space(corridor, options));
  const auto through = (*planner)->plan({Pose{2.5, 1.5, 0}, {Pose{8.5, 1.5, 0}}});
  ASSERT_TRUE(through.has_value());
  EXPECT_DOUBLE_EQ(through->cost, 6);
  const auto turned = (*planner)->plan({Pose{5.5, 1.5, 0}, {Pose{5.5, 1.5, kPi}}});
  ASSERT_FALSE(turned.has_value()) << "it would have to leave the map";
  EXPECT_EQ(turned.error().status, Status::unreachable);
}

TEST(LatticeConformance, NeedsPrimitivesForItsCells) {
  MotionPrimitives::Parts parts{.resolution = 0.1,
                                .headings = {0},
                                .primitives = {{0, 0, 0, {1, 0}, 1, {{0, 0, 0}, {1, 0, 0}}}}};
  const MotionPrimitives primitives = *MotionPrimitives::make(parts);
  const auto plan_on = [&](double resolution) {
    Frame frame;
    frame.metric = true;
    frame.resolution = resolution;
    const FreeSpace space =
        *make_free_space(drawn_map("........", frame), {.primitives = primitives});
    return make_planner("lattice", space);
  };
  const auto coarse = plan_on(0.2);
  ASSERT_FALSE(coarse.has_value());
  EXPECT_EQ(coarse.error().status, Status::unsupported_map);
  EXPECT_EQ(coarse.error().message,
            "the motion primitives are for cells of 0.1 m, which must be 0.2 m, the resolution of "
            "the map, or a whole multiple of it");
  ASSERT_TRUE(plan_on(0.1).has_value());
  const auto fine = plan_on(0.05);
  ASSERT_TRUE(fine.has_value());
  const auto plan = (*fine)->plan({Pose{0.5, 0.5, 0}, {Pose{6.6, 0.5, 0.1}}});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->path.driven_poses().size(), 4U) << "steps of two cells";
  EXPECT_NEAR(plan->goal_snapping_error.distance, 0.1, 1e-12);
  EXPECT_NEAR(plan->goal_snapping_error.turn, 0.1, 1e-12);
}

/// A free map with these metres a cell, for a robot that is a point.
FreeSpace free_yard(double resolution) {
  Frame frame;
  frame.resolution = resolution;
  return *make_free_space(*make_grid_map(Grid<CellState>(40, 40, CellState::free), frame));
}

TEST(LatticeUpdate, ItsTurningCircleIsInMetresOnEveryMap) {
  const OptionValues options{{"turning_radius", "2"}};
  const Query query{{5.5, 5.5, 0}, {Pose{30.5, 28.5, kPi / 2}}};
  const auto updated = *make_planner("lattice", free_yard(1), options);
  for (const double resolution : {0.5, 1.0, 0.25}) {
    ASSERT_TRUE(updated->update(free_yard(resolution)));
    const auto fresh = *make_planner("lattice", free_yard(resolution), options);
    const auto expected = fresh->plan(query);
    const auto plan = updated->plan(query);
    ASSERT_TRUE(expected && plan) << resolution;
    EXPECT_EQ(plan->path, expected->path) << resolution;
    EXPECT_EQ(plan->cost, expected->cost) << resolution;
  }
}

TEST(LatticeUpdate, AMapThatIsTooFineIsAnErrorAsWhenMakingIt) {
  const OptionValues options{{"turning_radius", "20"}};
  const auto planner = *make_planner("lattice", free_yard(1), options);
  const FreeSpace fine = free_yard(1e-4);
  const auto made = make_planner("lattice", fine, options);
  ASSERT_FALSE(made);
  const auto updated = planner->update(fine);
  ASSERT_FALSE(updated);
  EXPECT_EQ(updated.error().message, made.error().message);
  const Query query{{5.5, 5.5, 0}, {Pose{30.5, 28.5, 0}}};
  const auto plan = planner->plan(query);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().status, Status::unsupported_map);
  EXPECT_EQ(plan.error().message, made.error().message);
  ASSERT_TRUE(planner->update(free_yard(1)));
  EXPECT_TRUE(planner->plan(query));
}

}  // namespace
}  // namespace wend::test
