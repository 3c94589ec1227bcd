// An index is built by several threads, saved, opened, and asked by several threads at once. Run under
// a thread sanitizer too: scripts/tsan.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/generate/generators.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/io/files.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr double kRelative = 1e-9;
constexpr int kThreads = 4;

class SharedIndex : public ::testing::TestWithParam<std::string> {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  const PlannerInfo& info() const { return *planners().find(GetParam()); }

  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      ("wend_shared_index_" + GetParam() + "_" + std::to_string(::getpid()));
};

FreeSpace space_of(const char* generator, const OptionValues& options = {}) {
  const auto map = make_map(generator, 160, 100, 5, options);
  return *make_free_space(map.value());
}

/// The queries of one thread, and whether what came is what a planner without an index says.
std::string wrong_answer(Planner& planner, Planner& reference, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const FreeSpace& space = planner.free_space();
    const int start_x = random.between(0, space.width() - 1);
    const int start_y = random.between(0, space.height() - 1);
    const int goal_x = random.between(0, space.width() - 1);
    const int goal_y = random.between(0, space.height() - 1);
    const Query query = Query::between({start_x, start_y}, {goal_x, goal_y});
    Plan plan;
    Plan expected;
    const Status status = planner.plan(query, plan);
    if (status != reference.plan(query, expected)) return "another status";
    if (status != Status::found) continue;
    if (std::abs(plan.cost - expected.cost) > kRelative * (1 + expected.cost)) {
      return "cost " + std::to_string(plan.cost) + ", not " + std::to_string(expected.cost);
    }
  }
  return {};
}

TEST_P(SharedIndex, AnswersManyThreadsAsItShould) {
  for (const char* generator : {"office", "maze", "random"}) {
    SCOPED_TRACE(generator);
    const FreeSpace space = space_of(generator);
    ThreadWorkers workers(kThreads);
    const auto built = info().index_support->build(space, {&workers, {}, nullptr});
    ASSERT_TRUE(built) << built.error().message;
    ASSERT_TRUE(write_index(file_, *built));
    const auto opened = open_index(file_);
    ASSERT_TRUE(opened);
    std::vector<std::string> wrong(kThreads);
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back([&, i] {
          const auto planner = info().index_support->make_planner(space, {}, *opened);
          const auto reference =
              make_planner(info().capabilities.any_angle ? "any_angle" : "astar", space);
          std::string& said = wrong[static_cast<std::size_t>(i)];
          said = planner ? wrong_answer(**planner, **reference, static_cast<std::uint64_t>(i))
                         : planner.error().message;
        });
      }
    }
    for (const std::string& said : wrong) EXPECT_EQ(said, "");
  }
}

/// Whoever writes to the file while it is open harms nobody; who opens it then learns that it is damaged.
TEST_P(SharedIndex, SurvivesThatItsFileIsOverwritten) {
  const FreeSpace space = space_of("office");
  const auto built = info().index_support->build(space, {});
  ASSERT_TRUE(built && write_index(file_, *built));
  const auto opened = open_index(file_);
  ASSERT_TRUE(opened);
  std::ofstream(file_, std::ios::binary | std::ios::trunc) << "something else";  // in place
  EXPECT_TRUE(std::ranges::equal(opened->bytes(), built->bytes()));
  const auto planner = info().index_support->make_planner(space, {}, *opened);
  const auto reference = make_planner(info().capabilities.any_angle ? "any_angle" : "astar", space);
  ASSERT_TRUE(planner && reference);
  EXPECT_EQ(wrong_answer(**planner, **reference, 1), "");
  const auto damaged = open_index(file_);
  ASSERT_TRUE(damaged);
  EXPECT_FALSE(info().index_support->make_planner(space, {}, *damaged));
}

TEST_P(SharedIndex, IsTheSameHoweverManyThreadsBuildIt) {
  const FreeSpace space = space_of("random", {{"density", "0.3"}});
  OneWorker one;
  ThreadWorkers many(kThreads);
  const auto alone = info().index_support->build(space, {&one, {}, nullptr});
  const auto together = info().index_support->build(space, {&many, {}, nullptr});
  ASSERT_TRUE(alone && together);
  EXPECT_TRUE(std::ranges::equal(alone->bytes(), together->bytes()));
}

TEST_P(SharedIndex, TellsHowFarItIsAndStopsWhenToldTo) {
  const FreeSpace space = space_of("random", {{"density", "0.3"}});
  std::atomic<bool> cancel{false};
  double last = 0;
  const auto whole = info().index_support->build(space, {nullptr,
                                                         [&](double share) {
                                                           EXPECT_GE(share, last);
                                                           EXPECT_LE(share, 1);
                                                           last = share;
                                                         },
                                                         &cancel});
  ASSERT_TRUE(whole);
  EXPECT_GT(last, 0.9);
  cancel = true;
  const auto stopped = info().index_support->build(space, {nullptr, {}, &cancel});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().status, Status::cancelled);
}

TEST_P(SharedIndex, OfAnotherMapIsAMismatch) {
  const FreeSpace space = space_of("office");
  const auto built = info().index_support->build(space, {});
  ASSERT_TRUE(built);
  const auto planner = info().index_support->make_planner(space_of("maze"), {}, *built);
  ASSERT_FALSE(planner);
  EXPECT_EQ(planner.error().status, Status::index_mismatch);
  EXPECT_NE(planner.error().message.find("another map"), std::string::npos);
}

std::vector<std::string> planners_with_index() {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : planners()) {
    if (planner.index_support) names.push_back(planner.name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Registry, SharedIndex, ::testing::ValuesIn(planners_with_index()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend
