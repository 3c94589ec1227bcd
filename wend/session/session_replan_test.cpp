// Sessions of robots that plan again: the path has the kind, the ends and the cost that plan() gives it, and is kept
// unless another one is cheaper by the share that was asked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/map/own_costs.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/polyline.hpp"
#include "wend/planner/rest_of_path.hpp"
#include "wend/session/resuming.hpp"
#include "wend/session/session.hpp"
#include "wend/session/walled_room_test.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

using test::across;
using test::walled_room;

constexpr double kSame = 1e-9;  // of a cost

PlannerSpec spec_of(const std::string& text) { return parse_planner_specs(text)->front(); }

/// Every planner, some with other options.
std::vector<PlannerSpec> every_planner() {
  std::vector<PlannerSpec> specs;
  for (const PlannerInfo& info : planners()) specs.push_back({info.name});
  for (const char* more : {"astar:weight=1.5", "astar:connectivity=4", "bfs:connectivity=4",
                           "car:lattice_resolution=2", "theta_star:corner_rule=both",
                           "hybrid_astar:turning_radius=0.6,allow_reverse=false",
                           "hybrid_astar:motion_model=differential",
                           "hybrid_astar:motion_model=omni", "lattice:reverse_factor=3"}) {
    specs.push_back(spec_of(more));
  }
  return specs;
}

std::string name_of_kind(const Path& path) {
  return path.driven() ? "poses" : path.waypoints().empty() ? "cells" : "waypoints";
}

bool is_optimal(const PlannerSpec& spec) {
  return planners().find(spec.name)->guarantee == Guarantee::optimal || spec.name == "any_angle" ||
         spec.name == "euclidean_labels" || (spec.name == "astar" && spec.options.empty());
}

void expect_same_pose(const Pose& a, const Pose& b) {
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_NEAR(a.y, b.y, 1e-6);
  EXPECT_NEAR(std::remainder(a.heading - b.heading, 2 * kPi), 0, 1e-6);
}

/// What plan() answers in a new session on the same map, for the same robot; in the same session where an edit has ended
/// an index.
Expected<PlanAnswer, RequestFailure> planned(Session& session, const PlanRequest& request) {
  const FreeSpace space = session.view()->space;
  if (planners().find(request.planner.name)->index_support) return session.plan(request);
  return Session(space.map(), space.options()).plan(request);
}

/// What replan() answered beside what plan() does.
void expect_alike(const Expected<PlanAnswer, RequestFailure>& again,
                  const Expected<PlanAnswer, RequestFailure>& fresh, const PlanRequest& request,
                  const FreeSpace& space) {
  if (!fresh) {
    if (again && again->kept) return;  // a planner that is not complete
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().status, fresh.error().status);
    return;
  }
  ASSERT_TRUE(again) << again.error().message;
  const Path& path = again->plan.path;
  const Path& expected = fresh->plan.path;
  EXPECT_EQ(name_of_kind(path), name_of_kind(expected));
  EXPECT_EQ(again->moves, fresh->moves);
  EXPECT_EQ(again->refined.has_value(), fresh->refined.has_value());
  EXPECT_EQ(again->trajectory.has_value(), fresh->trajectory.has_value());
  EXPECT_NEAR(distance(path.points().front(), expected.points().front()), 0, 1e-6);
  if (path.driven()) expect_same_pose(path.poses().front(), expected.poses().front());
  EXPECT_LE(again->plan.cost, fresh->plan.cost * (1 + 2e-6));
  if (is_optimal(request.planner) || !again->kept) {
    EXPECT_NEAR(again->plan.cost, fresh->plan.cost, 2e-6 * fresh->plan.cost);
  }
  if (!path.driven()) return;
  const double radius = measure(expected, space)->smallest_turning_radius;
  if (again->kept) {
    EXPECT_FALSE(first_collision(path, space));
    return;
  }
  EXPECT_DOUBLE_EQ(measure(path, space)->smallest_turning_radius, radius);
  expect_same_pose(path.poses().back(), expected.poses().back());
}

GridMap with_random_costs(const GridMap& map, Random& random) {
  return *with_terrain(map,
                       [&](Cell /*cell*/) { return 1.0 + static_cast<double>(random.below(3)); });
}

GridMap small_room(Random& random) {
  Grid<CellState> cells(24, 18, CellState::free);
  for (int i = 0; i < 14; ++i) {
    const int x = static_cast<int>(random.below(22));
    const int y = static_cast<int>(random.below(16));
    for (const Cell by : {Cell{0, 0}, Cell{1, 0}, Cell{0, 1}}) {
      cells[{x + by.x, y + by.y}] = CellState::occupied;
    }
  }
  return *make_grid_map(cells, {.resolution = 0.2, .origin = {1, 2, 0.3}, .metric = true});
}

MapPose somewhere(const GridMap& map, Random& random) {
  const Cell cell{static_cast<int>(random.below(24)), static_cast<int>(random.below(18))};
  return map.frame().to_metres(pose_at(cell, random.between(0, 3) * kPi / 2));
}

MapEdit random_edit(Random& random) {
  const Cell corner{static_cast<int>(random.below(22)), static_cast<int>(random.below(16))};
  const auto state = random.below(2) == 0 ? CellState::free : CellState::occupied;
  return {.corner = corner, .states = Grid<CellState>(2, 2, state)};
}

struct Situation {
  FreeSpaceOptions robot = {};
  bool costs = false;
  bool tolerance = false;
  bool several_goals = false;
  bool any_heading = false;
  bool refined = false;
};

std::vector<Situation> situations() {
  return {{},
          {.robot = {.footprint = Footprint::disc(0.15)}, .any_heading = true},
          {.robot = {.footprint = Footprint::disc(0.1), .clearance_distance = 0.6}},
          {.costs = true, .any_heading = true},
          {.robot = {.footprint = Footprint::disc(0.1)}, .tolerance = true},
          {.several_goals = true},
          {.refined = true}};
}

TEST(SessionReplan, AnswersAsPlanDoesWhateverThePlanner) {
  for (const PlannerSpec& spec : every_planner()) {
    int number = 0;
    for (const Situation& situation : situations()) {
      SCOPED_TRACE(spec.name + (spec.options.empty() ? "" : ":" + spec.options[0].first) +
                   " in situation " + std::to_string(number++));
      Random random(7);
      GridMap map = small_room(random);
      if (situation.costs) map = with_random_costs(map, random);
      Session session(map, situation.robot);
      for (int round = 0; round < test::share_of(4); ++round) {
        PlanRequest request{somewhere(map, random), {}};
        for (int i = 0; i < (situation.several_goals ? 3 : 1); ++i) {
          const MapPose goal = somewhere(map, random);
          MapGoal& added = request.goals.emplace_back(MapGoal{goal.point()});
          if (!situation.any_heading) added.heading = goal.heading;
          if (situation.tolerance) added.tolerance = added.heading_tolerance = 0.5;
        }
        request.planner = spec;
        request.explain = false;
        if (situation.refined) {
          request.refinement.simplify = Simplification{};
          request.trajectory = TrajectoryLimits{};
        }
        for (int edits = 0; edits < 3; ++edits) {
          const auto again = session.replan(request);
          expect_alike(again, planned(session, request), request, session.view()->space);
          ASSERT_TRUE(session.edit(random_edit(random)));
        }
      }
    }
  }
}

TEST(SessionReplan, TakesTheReplannerOnlyWherePathsAreTheSame) {
  Random random(3);
  const GridMap map = small_room(random);
  const auto uniform = *make_free_space(map, {});
  const auto costly = *make_free_space(with_random_costs(map, random), {});
  for (const char* spec : {"astar", "dijkstra", "astar:corner_rule=one", "astar:weight=1"}) {
    EXPECT_EQ(resuming(spec_of(spec), uniform).name, "replanner") << spec;
    EXPECT_EQ(resuming(spec_of(spec), costly).name, "replanner") << spec;
  }
  EXPECT_EQ(resuming(spec_of("jps"), uniform).name, "replanner");
  EXPECT_EQ(resuming(spec_of("jps"), costly).name, "jps") << "it refuses costs";
  for (const char* spec : {"astar:weight=2", "astar:neighbour_order=uldr", "dijkstra:ties=oldest",
                           "astar:connectivity=5", "alt", "d_star_lite", "replanner", "ara_star",
                           "hub_labels", "any_angle", "theta_star", "greedy", "dfs", "random_walk",
                           "hybrid_astar", "lattice", "car"}) {
    EXPECT_EQ(resuming(spec_of(spec), uniform).name, spec_of(spec).name) << spec;
  }
  const PlannerSpec four = resuming(spec_of("astar:connectivity=4"), uniform);
  const auto planner = make_planner(four.name, uniform, four.options);
  ASSERT_TRUE(planner);
  EXPECT_EQ((*planner)->grid_moves()->connectivity, Connectivity::four);
}

/// The rest of a path from its start is the path, and from any of its poses on what the poses before it leave.
TEST(RestOfPath, CostsWhatThePlannerSaysOfTheWhole) {
  for (const PlannerSpec& spec : every_planner()) {
    for (const bool costs : {false, true}) {
      SCOPED_TRACE(spec.name + (spec.options.empty() ? "" : ":" + spec.options[0].second) +
                   (costs ? " with costs" : ""));
      Random random(11);
      GridMap map = small_room(random);
      if (costs) map = with_random_costs(map, random);
      const auto space = *make_free_space(map, {.footprint = Footprint::disc(0.1)});
      const auto planner = make_planner(spec.name, space, spec.options);
      if (!planner) continue;  // it refuses costs
      for (int i = 0; i < 12; ++i) {
        Query query{map.frame().to_grid(somewhere(map, random)),
                    {Goal(map.frame().to_grid(somewhere(map, random)))}};
        const auto plan = (*planner)->plan(query);
        if (!plan) continue;
        std::size_t passed = 0;
        query.start = plan->path.poses().front();
        const auto whole = (*planner)->rest_of(plan->path, query, passed);
        ASSERT_TRUE(whole);
        EXPECT_EQ(passed, 0U);
        // Costs of continuous ways are sampled, also between two cells, where rounding decides.
        const bool sampled = costs && spec.name == "hybrid_astar";
        EXPECT_NEAR(whole->cost, plan->cost, (sampled ? 0.3 : kSame) * (1 + plan->cost));
        EXPECT_EQ(whole->moves.empty(), plan->moves.empty());
        EXPECT_TRUE(whole->moves.empty() || whole->moves.size() + 1 == whole->path.size());
        double last = whole->cost;
        const std::vector<Pose> poses = plan->path.poses();
        for (std::size_t joint = 1; joint < poses.size(); ++joint) {
          query.start = poses[joint];
          const auto rest = (*planner)->rest_of(plan->path, query, passed);
          if (!rest && !plan->path.waypoints().empty()) break;  // the cell's middle is elsewhere
          ASSERT_TRUE(rest) << joint;
          EXPECT_LE(rest->cost, last * (1 + kSame) + (sampled ? 0.5 : kSame) +
                                    (plan->path.waypoints().empty() ? 0 : 1));
          last = rest->cost;
          EXPECT_NEAR(distance(rest->path.points().back(), poses.back().point()), 0, 1e-6);
        }
      }
    }
  }
}

/// A drive along the answers while the map changes. What is answered is compared with plan() at every step.
class Drive {
 public:
  Drive(PlannerSpec spec, double keep, std::uint64_t seed)
      : random_(seed),
        map_(small_room(random_)),
        session_(map_, {.footprint = Footprint::disc(seed % 2 == 0 ? 0 : 0.1)}) {
    request_.planner = std::move(spec);
    request_.keep = keep;
    request_.explain = false;
  }

  int kept() const { return kept_; }
  int changed() const { return changed_; }

  void run() {
    for (int tries = 0; tries < 10; ++tries) {
      request_.start = somewhere(map_, random_);
      const MapPose goal = somewhere(map_, random_);
      request_.goals = {{goal.point(), goal.heading}};
      if (planned(session_, request_)) break;
    }
    for (int step = 0; step < 12; ++step) {
      if (step > 0 && !session_.edit(random_edit(random_))) return;
      const FreeSpace space = session_.view()->space;
      const auto answer = session_.replan(request_);
      const auto fresh = planned(session_, request_);
      if (!answer) {
        EXPECT_FALSE(fresh);
        return;
      }
      check(*answer, fresh, space);
      request_.start = moved_along(*answer);
    }
  }

 private:
  void check(const PlanAnswer& answer, const Expected<PlanAnswer, RequestFailure>& fresh,
             const FreeSpace& space) {
    const Plan& plan = answer.plan;
    EXPECT_EQ(plan.cost >= 0 && std::isfinite(plan.cost), true);
    if (!answer.kept) {
      ++changed_;
      ASSERT_TRUE(fresh);
      EXPECT_NEAR(plan.cost, fresh->plan.cost, 2e-6 * (1 + plan.cost));
      return;
    }
    ++kept_;
    EXPECT_FALSE(first_collision(plan.path, space, Adjacency::edges));
    if (fresh) {
      EXPECT_GE(fresh->plan.cost, (1 - request_.keep) * plan.cost * (1 - 2e-6));
    }
    if (plan.path.of_steps() && answer.moves) {
      const auto cost = check_grid_path(space, *answer.moves, plan.path.cells());
      ASSERT_TRUE(cost) << cost.error().what;
      EXPECT_EQ(plan.cost, *cost);
    }
  }

  /// Some way along the answer, a little beside it.
  MapPose moved_along(const PlanAnswer& answer) {
    const std::vector<Pose> poses =
        answer.plan.path.driven() ? poses_along(JoinedPoses(answer.plan.path.driven_poses()), 0.7)
                                  : poses_along(polyline_of(answer.plan.path), 0.7);
    Pose pose = poses[std::min<std::size_t>(poses.size() - 1, random_.below(4))];
    const Pose beside{pose.x + 0.01 * random_.between(0, 20), pose.y, pose.heading + 0.01};
    if (answer.space.fits(beside)) pose = beside;
    return answer.space.map().frame().to_metres(pose);
  }

  Random random_;
  GridMap map_;
  Session session_;
  PlanRequest request_;
  int kept_ = 0;
  int changed_ = 0;
};

TEST(SessionReplan, KeepsAPathUnlessAnotherIsCheaperByTheShare) {
  for (const PlannerSpec& spec : every_planner()) {
    SCOPED_TRACE(spec.name);
    int kept = 0;
    int changed = 0;
    for (const double keep : {0.0, 0.2, 1.0}) {
      for (std::uint64_t seed = 0; seed < test::share_of(4U); ++seed) {
        Drive drive(spec, keep, seed);
        drive.run();
        kept += drive.kept();
        changed += drive.changed();
      }
    }
    if (test::share_of(4) < 4) continue;  // too few seeds to say anything
    const bool index = planners().find(spec.name)->index_support != nullptr;
    EXPECT_GT(kept, index ? 0 : 10) << "an index does not survive many edits";
    EXPECT_GE(changed, 3);
  }
}

/// With a door that makes the way cheaper by a share that is known.
class Door : public testing::TestWithParam<const char*> {
 protected:
  Door() { request_.planner = spec_of(GetParam()); }

  /// The share by which the way through the door is cheaper.
  double open() {
    const auto before = session_.replan(request_);
    EXPECT_TRUE(before);
    if (before) first_ = before->plan.path;
    EXPECT_TRUE(
        session_.edit({.corner = {50, 60}, .states = Grid<CellState>(1, 8, CellState::free)}));
    const auto after = Session(session_.view()->space.map()).plan(request_);
    EXPECT_TRUE(after);
    return before && after ? 1 - after->plan.cost / before->plan.cost : 0;
  }

  Session session_{walled_room()};
  PlanRequest request_ = across();
  Path first_;
};

TEST_P(Door, IsTakenOnlyIfItIsWorthIt) {
  const double gain = open();
  ASSERT_GT(gain, 0.05);
  request_.keep = gain + 0.01;
  const auto kept = session_.replan(request_);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_TRUE(kept->kept);
  EXPECT_EQ(kept->plan.path, first_);
  request_.keep = gain - 0.01;
  const auto taken = session_.replan(request_);
  ASSERT_TRUE(taken);
  EXPECT_FALSE(taken->kept);
  EXPECT_NEAR(taken->plan.cost / kept->plan.cost, 1 - gain, 1e-9);
  if (std::isfinite(taken->plan.bound)) {
    EXPECT_NEAR(kept->plan.bound, taken->plan.bound * kept->plan.cost / taken->plan.cost, 1e-6);
  }
}

TEST_P(Door, IsTakenByWhoHasLeftThePath) {
  open();
  request_.keep = 1;
  EXPECT_TRUE(session_.replan(request_)->kept);
  request_.start.x -= 0.4;  // 4 cells from it
  request_.start.y -= 0.4;
  const auto taken = session_.replan(request_);
  ASSERT_TRUE(taken);
  EXPECT_FALSE(taken->kept);
}

TEST_P(Door, IsTakenToAnotherGoal) {
  open();
  request_.keep = 1;
  request_.goals[0].point.x -= 0.1;
  EXPECT_FALSE(session_.replan(request_)->kept);
}

TEST_P(Door, IsTakenIfTheOtherWayIsClosed) {
  open();
  request_.keep = 1;
  ASSERT_TRUE(
      session_.edit({.corner = {50, 80}, .states = Grid<CellState>(1, 20, CellState::occupied)}));
  const auto taken = session_.replan(request_);
  ASSERT_TRUE(taken) << taken.error().message;
  EXPECT_FALSE(taken->kept);
}

INSTANTIATE_TEST_SUITE_P(SessionReplan, Door,
                         testing::Values("astar", "bfs", "any_angle", "theta_star",
                                         "hybrid_astar:turning_radius=0.4", "lattice",
                                         "car:lattice_resolution=2"));

TEST(SessionReplan, FollowsASmoothedPath) {
  Session session(walled_room());
  PlanRequest request = across();
  request.keep = 0.5;
  request.refinement.simplify = Simplification{};
  const auto first = session.replan(request);
  ASSERT_TRUE(first && first->refined);
  // Far from the cells of the plan, as the line that joins them is.
  const Polyline driven = polyline_of(first->path());
  const Polyline planned = polyline_of(first->plan.path);
  double farthest = 0;
  const Frame& frame = first->space.map().frame();
  for (double along = 0; along < driven.length(); along += 3) {
    const Pose pose = driven.at(along);
    farthest = std::max(farthest, planned.nearest(pose.point(), 0, planned.length()).distance);
    request.start = frame.to_metres(pose);
    const auto again = session.replan(request);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->kept) << along;
  }
  EXPECT_GT(farthest, 4);
}

TEST(SessionReplan, AnswersTheRestIfALimitEndsTheSearch) {
  Session session(walled_room());
  PlanRequest request = across();
  request.planner = {"hybrid_astar"};
  ASSERT_TRUE(session.replan(request));
  request.limits.expansions = 1;
  const auto kept = session.replan(request);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_TRUE(kept->kept);
  EXPECT_EQ(kept->plan.bound, Plan::kNoBound);
  EXPECT_EQ(session.plan(request).error().status, Status::expansion_limit);
}

TEST(SessionReplan, RefusesAShareThatIsNone) {
  Session session(walled_room());
  PlanRequest request = across();
  for (const double keep : {-0.1, std::numeric_limits<double>::quiet_NaN()}) {
    request.keep = keep;
    const auto refused = session.replan(request);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().status, Status::invalid_option);
    EXPECT_EQ(refused.error().message, "keep must be at least 0");
    EXPECT_EQ(refused.error().where, "keep");
  }
}

}  // namespace
}  // namespace wend
