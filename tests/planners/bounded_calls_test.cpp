// A limit on time is one of the whole call: the making of a planner, its search, the reason of a failure, and what is
// done with the path. CPU time of the thread is measured, so that other programs do not matter.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/path/smoothing/corner_rounding.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"

namespace wend {
namespace {

constexpr int kSide = 2048;
constexpr double kLimit = 0.01;
constexpr double kOvershoot = 0.02;

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define WEND_SANITIZED
#endif
#endif

/// How much slower the work between two looks at the clock is than in a release.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(WEND_SANITIZED)
constexpr double kSlower = 20;
#elif defined(NDEBUG)
constexpr double kSlower = 1;
#else
constexpr double kSlower = 2;
#endif

/// A fifth of the cells are obstacles. With a wall, no path joins the left with the right.
GridMap noise(bool wall, double share = 0.2) {
  Random random(1);
  Grid<CellState> cells(kSide, kSide, CellState::free);
  for (const Cell cell : every_cell(cells)) {
    const bool blocked = random.chance(share) || (wall && cell.x == kSide / 2);
    if (blocked) cells[cell] = CellState::occupied;
  }
  for (const int x : {1, kSide - 2}) {
    for (int y = 0; y < 6; ++y) {
      for (int dx = -1; dx <= 1; ++dx) cells[{x + dx, y}] = CellState::free;
    }
  }
  return *make_grid_map(cells);
}

PlanRequest request_for(std::string_view planner) {
  PlanRequest request{.start = {1.5, 1.5, 0}, .goals = {{{kSide - 1.5, 1.5}}}};
  request.planner = {std::string(planner)};
  request.limits.seconds = kLimit;
  return request;
}

/// A robot that needs distances and has costs near obstacles, which are rarer, so that it passes.
FreeSpaceOptions careful_robot() {
  return {.footprint = Footprint::disc(1.5), .clearance_distance = 4};
}

/// One whose reach is beyond the distances that are made in bytes.
FreeSpaceOptions far_sighted_robot() {
  return {.footprint = Footprint::disc(1.5), .clearance_distance = 100};
}

/// The CPU time of a call beyond its limit.
template <class Call>
double overshoot(Call&& call) {
  const double begin = thread_cpu_seconds();
  call();
  return thread_cpu_seconds() - begin - kLimit;
}

class BoundedCalls : public testing::TestWithParam<bool> {
 protected:
  static Session& session(bool wall) {
    static Session open(noise(false));
    static Session walled(noise(true));
    Session& one = wall ? walled : open;
    EXPECT_TRUE(one.view());
    return one;
  }
};

/// Each planner, made within the limit, and again.
TEST_P(BoundedCalls, PlanWithEveryPlanner) {
  Session& planning = session(GetParam());
  for (const PlannerInfo& info : planners()) {
    for (int time = 0; time < 2; ++time) {
      EXPECT_LT(overshoot([&] { planning.plan(request_for(info.name)); }), kOvershoot * kSlower)
          << info.name << ", call " << time + 1;
    }
  }
}

/// Costs near obstacles: planners prepare more.
TEST(BoundedCallsWithCosts, PlanWithEveryPlanner) {
  Session planning(noise(false, 0.01), careful_robot());
  ASSERT_TRUE(planning.view());
  for (const PlannerInfo& info : planners()) {
    for (int time = 0; time < 2; ++time) {
      EXPECT_LT(overshoot([&] { planning.plan(request_for(info.name)); }), kOvershoot * kSlower)
          << info.name << ", call " << time + 1;
    }
  }
}

/// The first call on a map makes the free space.
TEST(BoundedCallsOnNewMaps, EndInTimeAndAreAnsweredWithoutALimit) {
  for (const FreeSpaceOptions& robot : {careful_robot(), far_sighted_robot()}) {
    Session planning(noise(false, 0.01), robot);
    const auto within_limit = [&] {
      const auto answer = planning.plan(request_for("astar"));
      ASSERT_FALSE(answer);
      EXPECT_EQ(answer.error().status, Status::time_limit) << answer.error().message;
    };
    for (int time = 0; time < 2; ++time) {
      EXPECT_LT(overshoot(within_limit), kOvershoot * kSlower) << "call " << time + 1;
    }
    const std::atomic<bool> cancel = true;
    PlanRequest cancelled = request_for("astar");
    cancelled.limits = {.clock = {}, .cancel = &cancel};
    const auto stopped = planning.plan(cancelled);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().status, Status::cancelled);
    PlanRequest patient = request_for("greedy");
    patient.limits = {};
    EXPECT_TRUE(planning.plan(patient)) << "nothing half made was kept";
  }
}

/// What is made before a deadline is what is made without one.
TEST(BoundedCallsOnNewMaps, MakeTheSameFreeSpace) {
  const GridMap map = noise(false, 0.01);
  for (const FreeSpaceOptions& robot : {careful_robot(), far_sighted_robot()}) {
    Limits limits;
    limits.seconds = 1e9;
    const auto bounded =
        make_free_space(Obstacles(map, robot.obstacles()), robot.robot(), Deadline(limits));
    const auto other = make_free_space(map, robot);
    ASSERT_TRUE(bounded && other);
    EXPECT_TRUE(bounded->passable() == other->passable());
    EXPECT_TRUE(bounded->costs() == other->costs());
  }
}

TEST_P(BoundedCalls, RefineAndTimeThePath) {
  Session& planning = session(GetParam());
  for (const SmootherInfo& smoother : smoothers()) {
    if (smoother.drives) continue;
    PlanRequest request = request_for("jps");
    request.refinement.simplify = Simplification{};
    request.refinement.smoother = SmootherChoice{smoother.name};
    request.refinement.spacing = 0.5;
    request.trajectory = TrajectoryLimits{};
    planning.plan(request_for("jps"));  // made
    EXPECT_LT(overshoot([&] { planning.plan(request); }), kOvershoot * kSlower) << smoother.name;
  }
}

TEST_P(BoundedCalls, EaseTheQueryAndExplain) {
  Session& planning = session(GetParam());
  PlanRequest request = request_for("astar");
  request.nearest = true;
  request.closest = true;
  request.escape = 3;
  planning.plan(request_for("astar"));
  EXPECT_LT(overshoot([&] { planning.plan(request); }), kOvershoot * kSlower);
  request.limits.seconds = 1e9;
  request.closest = false;
  request.nearest = false;
  request.explain = false;
  const auto answer = planning.plan(request);
  ASSERT_EQ(answer.has_value(), !GetParam());
  if (answer) return;
  const auto view = planning.view();
  Limits limits;
  limits.seconds = kLimit;
  std::string why;
  const double over =
      overshoot([&] { why = planning.explain(*view, request, answer.error(), Deadline(limits)); });
  EXPECT_LT(over, kOvershoot * kSlower);
  EXPECT_NE(why.find("the limit on time"), std::string::npos) << why;
}

TEST_P(BoundedCalls, ComputeAField) {
  Session& planning = session(GetParam());
  Limits limits;
  limits.seconds = kLimit;
  const auto view = planning.view();
  EXPECT_LT(overshoot([&] { planning.cost_to_go(*view, {{1, 1}}, {}, limits); }),
            kOvershoot * kSlower);
}

/// A flag that is set ends everything that takes long.
TEST_P(BoundedCalls, EndWhenTheyAreCancelled) {
  Session& planning = session(GetParam());
  const std::atomic<bool> cancel = true;
  for (const PlannerInfo& info : planners()) {
    PlanRequest request = request_for(info.name);
    request.limits.cancel = &cancel;
    bool planned = true;
    EXPECT_LT(overshoot([&] { planned = planning.plan(request).has_value(); }),
              kOvershoot * kSlower)
        << info.name;
    EXPECT_FALSE(planned) << info.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, BoundedCalls, testing::Bool(),
                         [](const auto& wall) { return wall.param ? "walled" : "open"; });

/// A path from side to side in many small steps.
Path zigzag() {
  std::vector<Point> points;
  for (int i = 0; i < 400'000; ++i) {
    points.push_back({1 + i * (kSide - 2) / 400'000.0, 1.2 + 0.7 * (i % 2)});
  }
  return Path::along(std::move(points));
}

/// Everything that is done with a path, by itself.
TEST(BoundedPaths, EndWithTheDeadline) {
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(kSide, 4, CellState::free)));
  const Path path = zigzag();
  const std::atomic<bool> cancel = true;
  const Deadline passed(Limits{.clock = {}, .cancel = &cancel});
  const auto is_cancelled = [](const auto& result) {
    return !result && result.error().status == Status::cancelled;
  };
  constexpr Adjacency kEdges = Adjacency::edges;
  EXPECT_TRUE(is_cancelled(string_pulled(path, space, kEdges, passed)));
  EXPECT_TRUE(is_cancelled(simplified(path, 0.1, space, kEdges, passed)));
  EXPECT_TRUE(is_cancelled(resampled(path, 0.5, space, kEdges, passed)));
  EXPECT_TRUE(is_cancelled(rounded_corners(path, space, 0.1, kEdges, passed)));
  EXPECT_TRUE(is_cancelled(Trajectory::along(path, space.map().frame(), {}, passed)));
  EXPECT_TRUE(is_cancelled(timed_path(path, space, kEdges, {}, 0.1, passed)));
}

}  // namespace
}  // namespace wend
