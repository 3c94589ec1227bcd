#include "bench/measure/speed_baseline.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

namespace wend {
namespace {

using testing::HasSubstr;
using testing::Not;

SpeedBaseline two_planners() {
  return {.machine = "a processor",
          .commit = "0123abc",
          .tolerance = 0.2,
          .sample = 50,
          .rows = {{"astar", {7, 9, 50}}, {"jps", {500, 60, 0.02}}}};
}

class SpeedBaselineFile : public testing::Test {
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

TEST_F(SpeedBaselineFile, IsReadAsItWasWritten) {
  write(baseline_json(two_planners()));
  const auto read = read_baseline(file_);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->machine, "a processor");
  EXPECT_EQ(read->commit, "0123abc");
  EXPECT_EQ(read->tolerance, 0.2);
  EXPECT_EQ(read->sample, 50U);
  ASSERT_EQ(read->rows.size(), 2U);
  EXPECT_EQ(read->rows[1].planner, "jps");
  EXPECT_EQ(read->rows[1].ratios.later, 500);
  EXPECT_EQ(read->rows[1].ratios.first, 60);
  EXPECT_EQ(read->rows[1].ratios.prepare, 0.02);
}

TEST_F(SpeedBaselineFile, OfAnotherKindIsRefused) {
  EXPECT_THAT(error(), HasSubstr(file_.filename().string()));
  write("{");
  EXPECT_THAT(error(), HasSubstr("not a baseline"));
  write("{\"schema\": 2}");
  EXPECT_THAT(error(), HasSubstr("schema 2 is not supported, only 1 is"));
  write("{\"schema\": 1}");
  EXPECT_THAT(error(), HasSubstr("not a baseline"));
}

TEST(SpeedBaselineVerdict, IsSlowerBeyondTheTolerance) {
  const auto verdict = [](SpeedRatios astar) {
    return compared(two_planners(), {{"astar", astar}, {"jps", {500, 60, 0.02}}});
  };
  EXPECT_FALSE(verdict({7, 9, 50}).slower);
  EXPECT_FALSE(verdict({5.7, 7.3, 50}).slower);
  EXPECT_FALSE(verdict({70, 90, 50}).slower) << "faster";
  EXPECT_TRUE(verdict({5.5, 9, 50}).slower);
  EXPECT_TRUE(verdict({7, 7, 50}).slower);
  EXPECT_TRUE(verdict({7, 9, 39}).slower);
  EXPECT_THAT(verdict({7, 7, 50}).table, HasSubstr("SLOWER"));
  EXPECT_THAT(verdict({7, 9, 50}).table, Not(HasSubstr("SLOWER")));
}

TEST(SpeedBaselineVerdict, IsATableOfNowBaselineAndChange) {
  const std::string table =
      compared(two_planners(), {{"astar", {14, 9, 30}}, {"jps", {450, 60, 0.02}}}).table;
  EXPECT_EQ(table,
            "planner  measure          now  baseline  change\n"
            "astar    later queries   14.0         7  +100 %\n"
            "         first query        9         9    +0 %\n"
            "         preparation     30.0      50.0   -40 %  SLOWER\n"
            "jps      later queries  450.0     500.0   -10 %\n"
            "         first query     60.0      60.0    +0 %\n"
            "         preparation     0.02      0.02    +0 %\n");
}

}  // namespace
}  // namespace wend
