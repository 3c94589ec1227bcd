// A Session that several threads use while its robot and its map change.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>
#include <vector>

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

}  // namespace
}  // namespace wend
