// `wend explore`, from outside.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* kHall =
    "..........\n"
    ".########.\n"
    ".#......#.\n"
    ".#.####.#.\n"
    "...#..#...\n";

class ExploreCommand : public testing::Test {
 protected:
  Outcome explore(std::vector<std::string> more) const {
    more.insert(more.begin(), {"explore", map_, "--start", "2,2", "--goal", "5,4"});
    return wend(std::move(more));
  }

  std::string first_bytes(const std::string& file) const {
    std::ifstream in(file, std::ios::binary);
    std::string bytes(4, ' ');
    in.read(bytes.data(), 4);
    return bytes;
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("hall.txt", kHall);
};

TEST_F(ExploreCommand, FindsThatTheGoalCannotBeReached) {
  const Outcome outcome = explore({});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("replanner: there is no path"));
  EXPECT_THAT(outcome.out, HasSubstr("unreachable"));
}

TEST_F(ExploreCommand, DrivesWithEachPlannerAndTellsWhatItTook) {
  const Outcome outcome =
      wend({"explore", map_, "--start", "2,2", "--goal", "0,0", "--sensor-range", "2", "--planner",
            "replanner,astar:leaps=false,d_star_lite", "--format", "json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report.at("schema"), 1);
  EXPECT_EQ(report.at("sensor_range_cells"), 2);
  ASSERT_EQ(report.at("drives").size(), 3U);
  for (const json& drive : report.at("drives")) {
    EXPECT_EQ(drive.at("status"), "found");
    EXPECT_GE(drive.at("replans"), 1);
    EXPECT_EQ(drive.at("path").front(), (json{2, 2}));
    EXPECT_EQ(drive.at("path").back(), (json{0, 0}));
    EXPECT_GE(drive.at("driven_cells"), 8.0);
    EXPECT_GE(drive.at("planning_us"), drive.at("worst_us"));
  }
  EXPECT_EQ(report.at("drives")[1].at("planner"), "astar:leaps=false");
}

TEST_F(ExploreCommand, ArrivesWhileItKeepsItsPath) {
  const Outcome outcome = wend({"explore", map_, "--start", "2,2", "--goal", "0,0",
                                "--sensor-range", "2", "--keep", "1", "--replan", "discovery"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("replanner"));
}

TEST_F(ExploreCommand, PlansOnceOnAKnownMap) {
  const Outcome outcome = wend(
      {"explore", map_, "--known", map_, "--start", "2,2", "--goal", "0,0", "--format", "csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("planner,status,reason,driven_cells,"));
  EXPECT_THAT(outcome.out, HasSubstr("replanner,found,,"));
  EXPECT_THAT(outcome.out, HasSubstr(",1,0,"));  // a plan, nothing new seen
}

TEST_F(ExploreCommand, WritesFilmPictureAndTables) {
  const std::string film = folder_ / "drive.gif";
  const std::string picture = folder_ / "drive.png";
  const std::string table = folder_ / "drive.csv";
  const Outcome outcome = wend(
      {"explore", map_, "--start", "2,2", "--goal", "0,0", "-o", film, "-o", picture, "-o", table});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(first_bytes(film), "GIF8");
  EXPECT_EQ(first_bytes(picture).substr(1), "PNG");
  EXPECT_EQ(first_bytes(table), "plan");
}

TEST_F(ExploreCommand, SaysWhatIsWrong) {
  const auto error = [&](std::vector<std::string> more) {
    const Outcome outcome = explore(std::move(more));
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    return outcome.err;
  };
  EXPECT_THAT(error({"--planner", "theta_star"}),
              HasSubstr("an explorer steps from cell to cell, which theta_star does not"));
  EXPECT_THAT(error({"--planner", "replanner:weight=2"}), HasSubstr("weight"));
  EXPECT_THAT(error({"--sensor-range", "0.5"}), HasSubstr("at least 1 cell"));
  EXPECT_THAT(error({"--keep", "nan"}), HasSubstr("--keep"));
  EXPECT_THAT(error({"--replan", "never"}), AllOf(HasSubstr("path"), HasSubstr("discovery")));
  EXPECT_THAT(error({"--known", folder_.write("small.txt", "..\n")}),
              HasSubstr("the known map has 2 x 1 cells, the true one 10 x 5"));
  EXPECT_THAT(error({"-o", map_}), HasSubstr("hall.txt"));
}

}  // namespace
}  // namespace wend::test
