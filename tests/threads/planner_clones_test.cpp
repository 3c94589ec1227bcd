// Planner::clone(): clones answer as the planner does that they were made of, also after its end, and at
// once on several threads. Run under a thread sanitizer too: scripts/tsan.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

constexpr int kClones = 8;

FreeSpace rooms() { return *make_free_space(*make_map("rooms", 60, 40, 3)); }

std::vector<Query> queries_on(const FreeSpace& space, std::uint64_t seed) {
  Random random(seed);
  std::vector<Query> queries;
  for (int i = 0; i < 25; ++i) {
    const Cell start{random.between(0, space.width() - 1), random.between(0, space.height() - 1)};
    const Cell goal{random.between(0, space.width() - 1), random.between(0, space.height() - 1)};
    queries.push_back(Query::between(start, goal));
  }
  return queries;
}

struct Answers {
  std::vector<Status> statuses;
  std::vector<Path> paths;

  friend bool operator==(const Answers&, const Answers&) = default;
};

Answers answers_of(Planner& planner, const std::vector<Query>& queries) {
  Answers answers;
  Plan plan;
  for (const Query& query : queries) {
    answers.statuses.push_back(planner.plan(query, plan));
    answers.paths.push_back(plan.path);
  }
  return answers;
}

class PlannerClone : public ::testing::TestWithParam<std::string> {};

TEST_P(PlannerClone, AnswersAsItsOriginalOnAThreadOfItsOwn) {
  auto planner = make_planner(GetParam(), rooms());
  ASSERT_TRUE(planner) << planner.error().message;
  const std::vector<Query> queries = queries_on((*planner)->free_space(), 11);
  const Answers expected = answers_of(**planner, queries);
  std::vector<std::unique_ptr<Planner>> clones(kClones);
  for (auto& clone : clones) clone = (*planner)->clone();
  planner->reset();

  std::vector<Answers> answers(kClones);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < clones.size(); ++i) {
    threads.emplace_back([&, i] { answers[i] = answers_of(*clones[i], queries); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Answers& answer : answers) EXPECT_EQ(answer, expected);
}

TEST_P(PlannerClone, IsUpdatedByItself) {
  const auto planner = make_planner(GetParam(), rooms());
  ASSERT_TRUE(planner) << planner.error().message;
  const auto clone = (*planner)->clone();
  const auto office = make_map("maze", 31, 21, 5);
  ASSERT_TRUE(office) << office.error().message;
  ASSERT_TRUE(clone->update(*make_free_space(*office)));
  EXPECT_EQ(clone->free_space().width(), 31);
  EXPECT_EQ((*planner)->free_space().width(), 60);
  const auto fresh = make_planner(GetParam(), *make_free_space(*office));
  ASSERT_TRUE(fresh) << fresh.error().message;
  const std::vector<Query> queries = queries_on(clone->free_space(), 12);
  EXPECT_EQ(answers_of(*clone, queries), answers_of(**fresh, queries));
}

INSTANTIATE_TEST_SUITE_P(Registry, PlannerClone, ::testing::ValuesIn(planners().names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wend
