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
#include "wend/planner/planners.hpp"
#include "wend/session/session.hpp"

namespace wend {
namespace {

constexpr int kSide = 2048;
constexpr double kLimit = 0.01;
constexpr double kOvershoot = 0.02;

/// How much slower this build is than a release.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSlower = 100;  // the making of a free space is not bounded
#elif defined(NDEBUG)
constexpr double kSlower = 1;
#else
constexpr double kSlower = 8;
#endif

/// A fifth of the cells are obstacles. With a wall, no path joins the left with the right.
GridMap noise(bool wall) {
  Random random(1);
  Grid<CellState> cells(kSide, kSide, CellState::free);
  for (const Cell cell : every_cell(cells)) {
    const bool blocked = random.chance(0.2) || (wall && cell.x == kSide / 2);
    if (blocked) cells[cell] = CellState::occupied;
  }
  for (const int x : {1, kSide - 2}) {
    for (int y = 0; y < 4; ++y) {
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

TEST_P(BoundedCalls, RefineAndTimeThePath) {
  Session& planning = session(GetParam());
  for (const SmootherInfo& smoother : smoothers()) {
    if (smoother.drives) continue;
    PlanRequest request = request_for("jps");
    request.refinement.simplify = Simplification{};
    request.refinement.smoother = SmootherChoice{smoother.name};
    request.refinement.spacing = 0.5;
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

}  // namespace
}  // namespace wend
