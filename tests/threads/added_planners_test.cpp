// Planners that are added while threads read the registry. (In the program of threads: what is added
// stays, and the other tests of this program name the planners that they use.)

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

PlannerInfo astar_as(const std::string& name) {
  PlannerInfo info = *planners().find("astar");
  info.name = name;
  return info;
}

TEST(AddedPlanners, AreFoundAndPlan) {
  ASSERT_TRUE(add_planners({astar_as("added_a"), astar_as("added_b")}));
  EXPECT_EQ(planners().names().back(), "added_b");
  const FreeSpace space = *make_free_space(*make_grid_map(Grid<CellState>(5, 5, CellState::free)));
  const auto planner = make_planner("added_a", space, {{"weight", "1.5"}});
  ASSERT_TRUE(planner) << planner.error().message;
  EXPECT_TRUE((*planner)->plan(Query::between({0, 0}, {4, 4})));
  EXPECT_TRUE(parse_planner_specs("added_b:weight=2"));
}

TEST(AddedPlanners, WhatWasReadBeforeStaysValid) {
  const Registry<PlannerInfo>& before = planners();
  const PlannerInfo& astar = *before.find("astar");
  const std::size_t size = before.size();
  ASSERT_TRUE(add_planners({astar_as("added_later")}));
  EXPECT_EQ(before.size(), size);
  EXPECT_EQ(astar.name, "astar");
  EXPECT_EQ(before.find("added_later"), nullptr);
  EXPECT_NE(planners().find("added_later"), nullptr);
}

TEST(AddedPlanners, ThreadsReadWhileOthersAdd) {
  constexpr int kEach = 20;
  const std::size_t before = planners().size();
  std::atomic<bool> done = false;
  std::atomic<int> gaps = 0;
  std::thread reader([&] {
    std::size_t seen = before;
    while (!done) {
      const std::size_t now = planners().size();
      if (now < seen || planners().find("astar") == nullptr) ++gaps;
      seen = now;
    }
  });
  std::vector<std::thread> writers;
  for (int writer = 0; writer < 3; ++writer) {
    writers.emplace_back([writer] {
      for (int i = 0; i < kEach; ++i) {
        const auto name = "added_" + std::to_string(writer) + "_" + std::to_string(i);
        EXPECT_TRUE(add_planners({astar_as(name)}));
        EXPECT_NE(planners().find(name), nullptr);
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  done = true;
  reader.join();
  EXPECT_EQ(planners().size(), before + 3 * kEach);
  EXPECT_EQ(gaps, 0);
}

}  // namespace
}  // namespace wend::test
