// A Session that several threads use while its robot and its map change.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <new>
#include <thread>
#include <vector>

#include "wend/base/thread_workers.hpp"
#include "wend/session/session.hpp"

namespace wend {
namespace {

/// A room whose wall leaves a way at the top; narrower if `narrow`.
GridMap room_with_a_wall(bool narrow) {
  constexpr int kSide = 40;
  Grid<CellState> cells(kSide, kSide, CellState::free);
  for (int y = 0; y < (narrow ? 38 : 30); ++y) cells[{20, y}] = CellState::occupied;
  return *make_grid_map(cells);
}

PlanRequest request_for(const char* planner) {
  PlanRequest request{.start = {1.5, 1.5, 0}, .goals = {{{38.5, 1.5}}}};
  request.planner = {planner};
  return request;
}

/// Every answer is that of one of the two maps, whole: never a mixture.
TEST(SessionThreads, AnswerOnOneMapOrTheOther) {
  constexpr std::array<const char*, 2> kPlanners{"astar", "jps"};
  const auto cost_on = [](bool narrow) {
    return Session(room_with_a_wall(narrow)).plan(request_for("astar"))->plan.cost;
  };
  const double wide = cost_on(false);
  const double narrow = cost_on(true);
  ASSERT_NE(wide, narrow);
  Session session(room_with_a_wall(false));
  std::atomic<int> wrong = 0;
  std::atomic<int> of_wide = 0;
  std::atomic<bool> begun = false;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      const PlanRequest request = request_for(kPlanners[thread % kPlanners.size()]);
      for (int i = 0; i < 60; ++i) {
        const auto answer = session.plan(request);
        begun = true;
        if (!answer || (answer->plan.cost != wide && answer->plan.cost != narrow)) ++wrong;
        if (answer && answer->plan.cost == wide) ++of_wide;
      }
    });
  }
  while (!begun) std::this_thread::yield();
  for (int i = 0; i < 20; ++i) {
    session.set_map(room_with_a_wall(i % 2 == 0));
    session.set_robot({.footprint = Footprint::disc(i % 2 == 0 ? 0 : 0.25)});
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(of_wide, 0);
}

/// Edits are made while threads plan; every answer is one of the map that it names, and views that threads
/// hold never change. The spaces are asked by all of them for what is made when first asked.
TEST(SessionThreads, AnswerOnTheMapThatTheyNameWhileItIsEdited) {
  Session session(room_with_a_wall(false), {.footprint = Footprint::disc(1)});
  std::atomic<int> wrong = 0;
  std::atomic<bool> begun = false;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      const PlanRequest request = request_for(thread % 2 == 0 ? "astar" : "jps");
      for (int i = 0; i < 60; ++i) {
        const auto view = *session.view();
        const std::size_t passable = view.space.passable().count();
        const auto answer = session.plan(view, request);
        begun = true;
        if (!answer) {
          ++wrong;
          continue;
        }
        for (const Cell cell : answer->plan.path.cells())
          wrong += view.space.passable(cell) ? 0 : 1;
        view.space.clearance({1, 1});
        view.space.squared_half_cell_clearance();
        if (view.space.components().size_of_component({1, 1}, Adjacency::edges) == 0) ++wrong;
        if (view.space.passable().count() != passable) ++wrong;
      }
    });
  }
  while (!begun) std::this_thread::yield();
  for (int i = 0; i < 100; ++i) {
    const CellState state = i % 2 == 0 ? CellState::occupied : CellState::free;
    const auto change = session.edit({.corner = {20, 30}, .states = Grid<CellState>(1, 5, state)});
    if (!change || change->none()) ++wrong;
    session.plan(request_for("astar"));
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

/// Workers whose memory ends in the middle of a search: an observer of it throws.
class EndsTheMemory final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& /*event*/) override {}
  void on_relax(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& /*event*/) override { throw std::bad_alloc(); }
};

/// The exception of a worker reaches the caller, and a planner that it stopped answers nothing more.
TEST(SessionThreads, PlanAsBeforeAfterTheMemoryEndedInAWorker) {
  for (const char* const planner : {"astar", "dijkstra", "any_angle", "car"}) {
    SCOPED_TRACE(planner);
    Session session(room_with_a_wall(false));
    const auto expected = session.plan(request_for(planner));
    ASSERT_TRUE(expected);
    EndsTheMemory observer;
    std::vector<PlanRequest> requests(8, request_for(planner));
    requests[5].observer = &observer;
    ThreadWorkers workers(3);
    EXPECT_THROW(session.plan_all(requests, {planner}, workers), std::bad_alloc);
    EndsTheMemory again;
    PlanRequest stopped = request_for(planner);
    stopped.observer = &again;
    EXPECT_THROW(session.plan(stopped), std::bad_alloc);
    const auto answer = session.plan(request_for(planner));
    ASSERT_TRUE(answer) << answer.error().message;
    EXPECT_EQ(answer->plan.cost, expected->plan.cost);
  }
}

}  // namespace
}  // namespace wend
