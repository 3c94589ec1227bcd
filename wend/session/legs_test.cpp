// Plans through vias: what the legs of a plan have in common with plans that are made alone.

#include "wend/session/legs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"

namespace wend {
namespace {

constexpr int kColumns = 24;
constexpr int kRows = 18;

GridMap random_map(Random& random, double blocked) {
  Grid<CellState> cells(kColumns, kRows, CellState::free);
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      if (random.uniform() < blocked) cells[{x, y}] = CellState::occupied;
    }
  }
  return *make_grid_map(cells,
                        {.resolution = 0.1, .origin = {-2, 1, 0}, .y_up = true, .metric = true});
}

MapPoint random_place(Random& random) {
  return {-2 + 0.1 * kColumns * random.uniform(), 1 + 0.1 * kRows * random.uniform()};
}

PlanRequest random_round(const std::string& planner, Random& random) {
  const MapPoint start = random_place(random);
  PlanRequest request{{start.x, start.y, 6 * random.uniform() - 3}, {}, {planner}};
  if (planner == "hybrid_astar") request.planner.options = {{"turning_radius", "0.2"}};
  for (int vias = random.between(1, 3); vias > 0; --vias) {
    MapGoal& via = request.vias.emplace_back(MapGoal{random_place(random)});
    if (random.chance(0.5)) via.heading = 6 * random.uniform() - 3;
  }
  request.closed = random.chance(0.3);
  if (!request.closed) request.goals.push_back({random_place(random)});
  if (random.chance(0.2)) request.vias.front().point = {request.start.x, request.start.y};
  request.explain = random.chance(0.5);
  return request;
}

std::vector<Point> part(const Path& path, std::size_t first, std::size_t last) {
  const std::vector<Point> points = path.points();
  return {points.begin() + static_cast<std::ptrdiff_t>(first),
          points.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

/// A leg as a request of its own, in grid coordinates.
PlanRequest alone(const PlanRequest& whole, const Frame& frame, std::size_t leg,
                  const Pose& begin) {
  PlanRequest request = whole;
  request.vias.clear();
  request.closed = false;
  request.coordinates = MapUnits::cells;
  request.start = {begin.x, begin.y, begin.heading};
  if (leg < whole.vias.size()) request.goals = {whole.vias[leg]};
  if (leg < whole.vias.size() || !whole.closed) {
    for (MapGoal& goal : request.goals) {
      const Pose at = frame.to_grid(MapPose{goal.point.x, goal.point.y, goal.heading.value_or(0)});
      goal.point = {at.x, at.y};
      if (goal.heading) goal.heading = at.heading;
    }
  }
  return request;
}

class EveryPlannersLegs : public testing::TestWithParam<std::string> {
 protected:
  bool headings() const { return planners().find(GetParam())->capabilities.headings; }
  bool random_walk() const { return GetParam() == "random_walk"; }
};

/// Every leg is the plan of another session from where the one before ended, and the path goes along all of them.
TEST_P(EveryPlannersLegs, AreThePlansMadeAlone) {
  Random random(5);
  int found = 0;
  const int queries = headings() ? 12 : 40;
  for (int query = 0; query < queries; ++query) {
    SCOPED_TRACE(query);
    const GridMap map = random_map(random, headings() ? 0.03 : 0.15);
    const FreeSpaceOptions robot{.footprint = Footprint::disc(query % 3 == 0 ? 0.07 : 0)};
    const PlanRequest request = random_round(GetParam(), random);
    Session together(map, robot);
    Session apart(map, robot);
    const auto answer = together.plan(request);
    const std::vector<PlanLeg>& legs = answer ? answer->legs : answer.error().legs;
    const Frame& frame = map.frame();
    Pose begin = frame.to_grid(request.start);
    Pose first_pose = begin;
    double cost = 0;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      SCOPED_TRACE("leg " + std::to_string(i));
      PlanRequest leg = alone(request, frame, i, begin);
      if (i == request.vias.size() && request.closed) {
        leg.goals = {{{first_pose.x, first_pose.y}}};
        if (headings()) leg.goals.front().heading = first_pose.heading;
      }
      const auto expected = apart.plan(leg);
      ASSERT_EQ(legs[i].status, expected ? Status::found : expected.error().status);
      if (!expected) {
        EXPECT_EQ(i + 1, legs.size());
        EXPECT_TRUE(answer.error().message.ends_with(expected.error().message))
            << answer.error().message << "\n"
            << expected.error().message;
        continue;
      }
      EXPECT_EQ(legs[i].cost, expected->plan.cost);
      EXPECT_EQ(legs[i].bound, expected->plan.bound);
      EXPECT_EQ(legs[i].metrics, expected->plan.metrics);
      cost += expected->plan.cost;
      if (answer) {
        EXPECT_EQ(part(answer->plan.path, legs[i].first, legs[i].last),
                  expected->plan.path.points());
      }
      const Path& path = expected->plan.path;
      begin = path.driven() ? path.driven_poses().back()
                            : Pose{path.points().back().x, path.points().back().y, 0};
      if (i == 0) {
        first_pose = path.driven() ? path.driven_poses().front()
                                   : Pose{path.points().front().x, path.points().front().y, 0};
      }
    }
    if (!answer) continue;
    ++found;
    ASSERT_EQ(legs.size(), request.vias.size() + 1);
    EXPECT_DOUBLE_EQ(answer->plan.cost, cost);
    EXPECT_EQ(legs.back().last + 1, answer->plan.path.size());
    if (!answer->plan.moves.empty()) {
      EXPECT_EQ(answer->plan.moves.size() + 1, answer->plan.path.size());
    }
    if (answer->moves && !random_walk()) {
      EXPECT_FALSE(first_collision(answer->plan.path, answer->space, answer->moves->adjacency()));
    }
    if (!request.closed) continue;
    const std::vector<Point> points = answer->plan.path.points();
    EXPECT_LT(distance(points.front(), points.back()), 1e-9);
  }
  if (!headings()) {
    EXPECT_GT(found, 3);
  }
}

std::vector<std::string> names_of_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    if (!info.index_support) names.push_back(info.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Legs, EveryPlannersLegs, testing::ValuesIn(names_of_planners()),
                         [](const auto& test) { return test.param; });

/// 12 x 3 m; a wall between them.
GridMap two_rooms() {
  return test::drawn_map(
      "............\n"
      "............\n"
      "............\n"
      "############\n"
      "............\n",
      {.resolution = 1, .metric = true});
}

PlanRequest around_the_room() {
  PlanRequest request{{1.5, 0.5, 0}, {{{10.5, 0.5}}}};
  request.vias = {{.point = {4.25, 2.75}}, {.point = {8.5, 2.5}}};
  return request;
}

TEST(Legs, PassTheViasExactly) {
  Session session(two_rooms());
  const auto answer = session.plan(around_the_room());
  ASSERT_TRUE(answer) << answer.error().message;
  ASSERT_EQ(answer->legs.size(), 3U);
  const std::vector<Point> points = answer->plan.path.points();
  EXPECT_EQ(points[answer->legs[0].last], (Point{4.25, 2.75}));
  EXPECT_EQ(points[answer->legs[1].last], (Point{8.5, 2.5}));
  EXPECT_EQ(answer->legs[0].goal_shift, 0);
  EXPECT_EQ(answer->legs[0].from, "start");
  EXPECT_EQ(answer->legs[0].to, "via 1");
  EXPECT_EQ(answer->legs[2].to, "goal");
  EXPECT_EQ(answer->joins(),
            (std::vector<std::size_t>{answer->legs[1].first, answer->legs[2].first}));
  EXPECT_EQ(answer->plan.bound, 1);
}

TEST(Legs, OfAClosedPathLeadBackToWhereItBegan) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  request.goals.clear();
  request.closed = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  const std::vector<Point> points = answer->plan.path.points();
  EXPECT_EQ(points.front(), (Point{1.5, 0.5}));
  EXPECT_EQ(points.back(), (Point{1.5, 0.5}));
  EXPECT_EQ(answer->legs.back().to, "start");
}

TEST(Legs, WithoutLengthAreAPoint) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  request.vias = {{.point = {1.5, 0.5}}, {.point = {1.5, 0.5}}};
  request.goals.front().point = {1.5, 0.5};
  request.refinement.smoother = SmootherChoice{};
  request.trajectory = TrajectoryLimits{};
  for (const bool stops : {false, true}) {
    request.stops_at_vias = stops;
    const auto answer = session.plan(request);
    ASSERT_TRUE(answer) << answer.error().message;
    EXPECT_EQ(answer->plan.path.size(), 1U);
    EXPECT_EQ(answer->plan.cost, 0);
    EXPECT_FALSE(answer->fault) << answer->fault->message;
    EXPECT_EQ(answer->trajectory->duration(), 0);
  }
}

TEST(Legs, NameTheOneThatFails) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  request.vias[1].point = {8.5, 4.5};
  const auto answer = session.plan(request);
  ASSERT_FALSE(answer);
  const RequestFailure& failure = answer.error();
  EXPECT_EQ(failure.status, Status::unreachable);
  EXPECT_TRUE(failure.message.starts_with("leg 2 of 3, from via 1 to via 2: ")) << failure.message;
  ASSERT_EQ(failure.legs.size(), 2U);
  EXPECT_EQ(failure.legs[0].status, Status::found);
  EXPECT_EQ(failure.legs[1].status, Status::unreachable);
  EXPECT_EQ(failure.metrics.expanded,
            failure.legs[0].metrics.expanded + failure.legs[1].metrics.expanded);
}

TEST(Legs, RefuseWhatDoesNotBelongTogether) {
  Session session(two_rooms());
  const auto refusal = [&](const PlanRequest& request) {
    const auto answer = session.plan(request);
    EXPECT_FALSE(answer);
    return answer ? "" : answer.error().message;
  };
  PlanRequest request = around_the_room();
  request.closed = true;
  EXPECT_EQ(refusal(request), "a closed path ends at its start: it has no goal");
  request.goals.clear();
  request.vias.clear();
  EXPECT_EQ(refusal(request), "a closed path needs a via");
  request = around_the_room();
  request.goals.clear();
  EXPECT_EQ(refusal(request), "there is no goal");
  request = around_the_room();
  request.on_solution = [](const Plan&) {};
  EXPECT_TRUE(refusal(request).starts_with("the paths of an anytime planner"));
  request = around_the_room();
  request.planner.name = "astr";
  EXPECT_TRUE(refusal(request).starts_with("there is no planner 'astr'"));
  request = around_the_room();
  const auto run = session.begin(request);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().message, "only plan() and plan_all() take vias: a search has one leg");
  EXPECT_EQ(session.replan(request).error().status, Status::unsupported_query);
}

TEST(Legs, RefuseNumbersThatAreNone) {
  Session session(two_rooms());
  for (const double number :
       {std::nan(""), std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
    PlanRequest request = around_the_room();
    request.vias[1].point.x = number;
    const auto outside = session.plan(request);
    ASSERT_FALSE(outside);
    EXPECT_EQ(outside.error().status, Status::goal_outside);
    request = around_the_room();
    request.vias[1].tolerance = number;
    EXPECT_EQ(session.plan(request).has_value(), number > 0) << number;
  }
}

/// Limits are of all legs together, and named as they were set.
TEST(Legs, ShareTheLimitOnExpansions) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  const std::uint64_t all = session.plan(request)->plan.metrics.expanded;
  for (std::uint64_t most = 0; most <= all; ++most) {
    SCOPED_TRACE(most);
    request.limits.expansions = most;
    const auto answer = session.plan(request);
    ASSERT_EQ(answer.has_value(), most == all);
    if (answer) continue;
    EXPECT_EQ(answer.error().status, Status::expansion_limit);
    EXPECT_EQ(answer.error().metrics.expanded, most);
  }
}

TEST(Legs, StopWhenTheyAreCancelledOrTimeIsOver) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  const std::atomic<bool> cancel = true;
  request.limits.cancel = &cancel;
  EXPECT_EQ(session.plan(request).error().status, Status::cancelled);
  request = around_the_room();
  request.limits.seconds = 0;
  EXPECT_EQ(session.plan(request).error().status, Status::time_limit);
}

/// Each time the clock is read, a second has passed: it never passes in one leg alone.
TEST(Legs, ShareTheTime) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  double now = 0;
  request.limits.clock = [&now] { return ++now; };
  request.limits.seconds = 1e6;
  ASSERT_TRUE(session.plan(request));
  const double reads = now;
  for (double seconds = 0; seconds < reads; ++seconds) {
    now = 0;
    request.limits.seconds = seconds;
    const auto answer = session.plan(request);
    if (!answer) {
      EXPECT_EQ(answer.error().status, Status::time_limit);
    }
    EXPECT_LE(now, reads + 20);
  }
}

TEST(Legs, OfAnAnytimePlannerGetEqualShares) {
  Random random(3);
  const GridMap map = random_map(random, 0.1);
  Session session(map);
  PlanRequest request{{-1.95, 1.05, 0}, {{{0.35, 2.75}}}, {"ara_star", {{"initial_weight", "3"}}}};
  request.vias = {{.point = {0.35, 1.05}}, {.point = {-1.95, 2.75}}};
  request.nearest = true;
  request.limits.expansions = 240;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_LE(answer->legs[0].metrics.expanded, 80U);
  EXPECT_LE(answer->plan.metrics.expanded, 240U);
}

TEST(Legs, OfManyRequestsAreThoseOfOne) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  const auto one = session.plan(request);
  PlanRequest plain = around_the_room();
  plain.vias.clear();
  const std::vector<PlanRequest> requests{request, plain, request};
  ThreadWorkers workers(2);
  const auto answers = session.plan_all(requests, {"astar"}, workers);
  ASSERT_TRUE(answers);
  EXPECT_EQ((*answers)[0]->plan.path, one->plan.path);
  EXPECT_EQ((*answers)[2]->legs.size(), 3U);
  EXPECT_TRUE((*answers)[1]->legs.empty());
}

TEST(Legs, BeginWithAWayOutAndEndClosest) {
  const GridMap map = test::drawn_map(
      "#...........\n"
      "............\n"
      "............\n"
      "############\n"
      "............\n",
      {.resolution = 1, .metric = true});
  Session session(map);
  PlanRequest request{{0.5, 0.5, 0}, {{{10.5, 4.5}}}};
  request.vias = {{.point = {6.5, 1.5}}};
  request.escape = 2;
  request.closest = true;
  request.refinement.smoother = SmootherChoice{};
  request.trajectory = TrajectoryLimits{};
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  ASSERT_TRUE(answer->lead_out);
  EXPECT_GT(answer->remaining.value_or(0), 1);
  const std::vector<Point> points = answer->plan.path.points();
  EXPECT_EQ(points.front(), (Point{0.5, 0.5}));
  EXPECT_EQ(points[answer->legs[0].last], (Point{6.5, 1.5}));
  EXPECT_EQ(points[answer->legs[1].first], (Point{6.5, 1.5}));
  ASSERT_TRUE(answer->refined);
  EXPECT_EQ(answer->refined->path.points()[answer->joins().front()], (Point{6.5, 1.5}));
  EXPECT_EQ(answer->notes.size(), 2U);
  request.vias.front().point = {6.5, 4.5};
  EXPECT_EQ(session.plan(request).error().status, Status::unreachable) << "a via must be reached";
}

TEST(Legs, AreMovedToTheNearestFreePlaceIfThatIsAsked) {
  Session session(two_rooms());
  PlanRequest request = around_the_room();
  request.vias.front().point = {4.5, 3.5};
  EXPECT_EQ(session.plan(request).error().status, Status::goal_blocked);
  request.nearest = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(answer->plan.path.points()[answer->legs[0].last], (Point{4.5, 2.5}));
  EXPECT_EQ(answer->legs[0].goal_shift, 1);
  ASSERT_EQ(answer->notes.size(), 1U);
  EXPECT_TRUE(answer->notes[0].starts_with("leg 1 of 3, from the start to via 1: "));
}

double speed_at(const Trajectory& trajectory, const MapPoint& place) {
  double nearest = std::numeric_limits<double>::infinity();
  double speed = 0;
  for (const TrajectoryState& state : trajectory.samples(0.001)) {
    const double apart = std::hypot(state.pose.x - place.x, state.pose.y - place.y);
    if (apart >= nearest) continue;
    nearest = apart;
    speed = state.speed;
  }
  EXPECT_LT(nearest, 0.2);
  return speed;
}

TEST(Legs, AreDrivenWithoutAStopUnlessItIsAsked) {
  Session session(test::drawn_map("..............\n..............\n..............\n",
                                  {.resolution = 1, .metric = true}));
  PlanRequest request{{0.5, 1.5, 0}, {{{12.5, 1.5}}}};
  request.vias = {{.point = {4.5, 1.5}}, {.point = {8.5, 0.5}}};
  request.trajectory = TrajectoryLimits{};
  const auto flowing = session.plan(request);
  ASSERT_TRUE(flowing && flowing->trajectory);
  EXPECT_GT(speed_at(*flowing->trajectory, {4.5, 1.5}), 0.1);
  EXPECT_GT(speed_at(*flowing->trajectory, {8.5, 0.5}), 0.01);
  request.stops_at_vias = true;
  const auto stopping = session.plan(request);
  ASSERT_TRUE(stopping && stopping->trajectory);
  EXPECT_NEAR(speed_at(*stopping->trajectory, {4.5, 1.5}), 0, 0.01);
  EXPECT_NEAR(speed_at(*stopping->trajectory, {8.5, 0.5}), 0, 0.01);
  EXPECT_GT(stopping->trajectory->duration(), flowing->trajectory->duration());
  double end = 0;
  for (const TrajectoryPiece& piece : stopping->trajectory->pieces()) {
    EXPECT_NEAR(piece.time, end, 1e-9);
    end = piece.time + piece.duration;
  }
  EXPECT_NEAR(end, stopping->trajectory->duration(), 1e-9);
}

/// A turn at a stop goes where the polygon fits: the two legs meet in half a turn beside a wall.
TEST(Legs, TurnAtAStop) {
  Session session(two_rooms());
  PlanRequest request{{1.5, 1.5, 0}, {{{1.5, 1.5}}}};
  request.vias = {{.point = {6.5, 1.5}}};
  request.trajectory = TrajectoryLimits{};
  request.stops_at_vias = true;
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer && answer->trajectory);
  double turned = 0;
  for (const MapSegment& segment : answer->trajectory->segments()) {
    if (segment.length == 0) turned += std::abs(segment.turn);
  }
  EXPECT_NEAR(turned, kPi, 1e-9);
}

/// With headings: the heading at a join is that in which the leg before ended, also after smoothing.
TEST(Legs, KeepTheHeadingAtTheirJoins) {
  Session session(test::drawn_map(std::string(20, '.') + "\n" +
                                      [] {
                                        std::string rows;
                                        for (int row = 0; row < 15; ++row)
                                          rows += std::string(20, '.') + "\n";
                                        return rows;
                                      }(),
                                  {.resolution = 0.5, .metric = true}));
  for (const char* const planner : {"hybrid_astar", "lattice", "car"}) {
    SCOPED_TRACE(planner);
    PlanRequest request{{1, 1, 0}, {{{8, 6}}}, {planner}};
    if (request.planner.name == "hybrid_astar") {
      request.planner.options = {{"turning_radius", "1"}};
      request.refinement.smoother = SmootherChoice{};
    }
    request.vias = {{.point = {4, 4}}, {.point = {7, 2}, .heading = kPi / 2}};
    request.trajectory = TrajectoryLimits{};
    for (const bool stops : {false, true}) {
      request.stops_at_vias = stops;
      const auto answer = session.plan(request);
      ASSERT_TRUE(answer) << answer.error().message;
      ASSERT_FALSE(answer->fault) << answer->fault->message;
      EXPECT_EQ(answer->plan.bound, Plan::kNoBound) << "the first via has no heading";
      const Path& path = answer->path();
      ASSERT_TRUE(path.driven());
      const Pose join = path.driven_poses()[answer->joins()[1]];
      EXPECT_NEAR(normalized_angle(join.heading - kPi / 2), 0, 1e-6);
      EXPECT_EQ(join, answer->plan.path.driven_poses()[answer->legs[1].last]);
      for (const MapSegment& segment : answer->trajectory->segments()) {
        if (request.planner.name != "lattice") {
          EXPECT_NE(segment.length, 0);
        }
      }
    }
  }
}

TEST(Legs, OfADriveWithHeadingsAtAllViasHaveABound) {
  Session session(two_rooms());
  PlanRequest request{{1, 1, 0}, {{{9, 1}}}, {"car"}};
  request.vias = {{.point = {5, 2}, .heading = 0.0}};
  const auto answer = session.plan(request);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(answer->plan.bound, 1);
}

}  // namespace
}  // namespace wend
