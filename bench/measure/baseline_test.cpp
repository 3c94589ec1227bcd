#include "bench/measure/baseline.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::Not;

Baseline two_planners() {
  return {.machine = "a processor",
          .commit = "0123abc",
          .times = "times as fast as a snail",
          .tolerance = 0.2,
          .sample = 50,
          .rows = {{"astar", "first query", 9}, {"jps", "first query", 60}, {"jps", "load", 0.02}}};
}

class BaselineFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  void write(const std::string& text) const { std::ofstream(file_) << text; }
  std::string error() const {
    const auto read = read_baseline(file_);
    return read ? "" : read.error().message;
  }

  std::filesystem::path file_ =
      testing::TempDir() + "wend_baseline_" + std::to_string(getpid()) + ".json";
};

TEST_F(BaselineFile, IsReadAsItWasWritten) {
  write(baseline_json(two_planners()));
  const auto read = read_baseline(file_);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->machine, "a processor");
  EXPECT_EQ(read->commit, "0123abc");
  EXPECT_EQ(read->times, "times as fast as a snail");
  EXPECT_EQ(read->tolerance, 0.2);
  EXPECT_EQ(read->sample, 50U);
  ASSERT_EQ(read->rows.size(), 3U);
  EXPECT_EQ(read->rows[2].subject, "jps");
  EXPECT_EQ(read->rows[2].measure, "load");
  EXPECT_EQ(read->rows[2].ratio, 0.02);
}

TEST_F(BaselineFile, OfAnotherKindIsRefused) {
  EXPECT_THAT(error(), HasSubstr(file_.filename().string()));
  write("{");
  EXPECT_THAT(error(), HasSubstr("not a baseline"));
  write("{\"schema\": 1}");
  EXPECT_THAT(error(), HasSubstr("schema 1 is not supported, only 2 is"));
  write("{\"schema\": 2}");
  EXPECT_THAT(error(), HasSubstr("not a baseline"));
}

TEST(BaselineVerdict, IsSlowerBeyondTheTolerance) {
  const auto verdict = [](double astar, double load) {
    return compared(
        two_planners(),
        {{"astar", "first query", astar}, {"jps", "first query", 60}, {"jps", "load", load}});
  };
  EXPECT_FALSE(verdict(9, 0.02).slower);
  EXPECT_FALSE(verdict(7.3, 0.0161).slower);
  EXPECT_FALSE(verdict(90, 2).slower) << "faster";
  EXPECT_TRUE(verdict(7, 0.02).slower);
  EXPECT_TRUE(verdict(9, 0.0159).slower);
  EXPECT_THAT(verdict(7, 0.02).table, HasSubstr("SLOWER"));
  EXPECT_THAT(verdict(9, 0.02).table, Not(HasSubstr("SLOWER")));
}

TEST(BaselineVerdict, IsATableOfNowBaselineAndChange) {
  const BaselineVerdict verdict = compared(
      two_planners(), {{"jps", "load", 0.02}, {"jps", "first query", 45}, {"bfs", "load", 3}});
  EXPECT_EQ(verdict.table,
            "subject  measure       now  baseline  change\n"
            "jps      load         0.02      0.02    +0 %\n"
            "         first query  45.0      60.0   -25 %  SLOWER\n"
            "bfs      load            3                    new\n"
            "astar    first query               9          NOT MEASURED\n");
  EXPECT_TRUE(verdict.slower);
}

TEST(BaselineVerdict, MissesWhatWasNotMeasured) {
  EXPECT_TRUE(compared(two_planners(), {{"astar", "first query", 9}}).slower);
}

}  // namespace
}  // namespace wend
