// `wend follow`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/corridor_grid.hpp"
#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class FollowCommand : public testing::Test {
 protected:
  Outcome follow(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"follow", map_, "--start", "0,0", "--goal", "9,4"});
    return wend(std::move(more));
  }

  Outcome follow_path(const std::string& path, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"follow", map_, "--path", path});
    return wend(std::move(more));
  }

  json drives(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--format", "json"});
    return json::parse(follow(std::move(more)).out).at("drives");
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kCorridorGrid);
};

TEST_F(FollowCommand, PlansForARobotThatIsLargerByTheMargin) {
  std::string wall;
  for (int y = 0; y < 12; ++y) wall += std::string(12, '.') + (y < 7 ? '#' : '.') + "...........\n";
  const std::string map = folder_.write("wall.txt", wall);
  const auto path = [&map](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--start", "2,2", "--goal", "21,2", "--planner", "astar"});
    arguments.insert(arguments.end(), {"--format", "json"});
    arguments.insert(arguments.begin() + 1, map);
    return json::parse(wend(arguments).out).at("path");
  };
  const json planned = path({"plan", "--robot-radius", "3"});
  EXPECT_EQ(path({"follow", "--robot-radius", "2", "--margin", "1"}), planned);
  EXPECT_EQ(path({"follow", "--footprint", "disc:2", "--margin", "1"}), planned);
  EXPECT_NE(path({"follow", "--robot-radius", "1", "--margin", "1"}), planned);
}

TEST_F(FollowCommand, DrivesAlongAPlannedAndSmoothedPath) {
  const Outcome outcome = follow({"--smooth"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("◆ driven"), HasSubstr("smoother  gradient\n"),
                                 HasSubstr("controller           pure_pursuit\n"),
                                 HasSubstr("outcome              reached the goal\n"),
                                 HasSubstr("collisions           0\n")));
}

TEST_F(FollowCommand, ComparesAllControllersThatFitTheRobot) {
  const json all = drives({"--compare"});
  ASSERT_GE(all.size(), 4U);
  for (const json& driven : all) {
    EXPECT_EQ(driven.at("outcome"), "reached") << driven.at("controller");
    EXPECT_EQ(driven.at("collisions"), 0) << driven.at("controller");
  }
  EXPECT_THAT(follow({"--compare=p,pid:heading_gain=3"}).out,
              AllOf(HasSubstr("controller          outcome"), HasSubstr("\npid:heading_gain=3  ")));
  EXPECT_LT(drives({"--compare", "--drivetrain", "bicycle"}).size(), all.size());
}

TEST_F(FollowCommand, SaysWhyTheGoalWasNotReached) {
  const Outcome outcome = follow({"--controller", "p", "--heading-gain", "0"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("wend: p: it got stuck after "));
  EXPECT_THAT(outcome.out, HasSubstr("outcome              got stuck\n"));
  EXPECT_EQ(follow({"--time-limit", "1"}).code, 1);
  EXPECT_EQ(follow({"--compare=p:heading_gain=0,pure_pursuit"}).code, 0) << "one of them did";
}

TEST_F(FollowCommand, SaysWhyThereIsNoPathWithTheMargin) {
  const Outcome outcome = follow({"--margin", "3"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("(these radii include the planning margin of 3 cells)"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST_F(FollowCommand, DrivesTheSameWithTheSameSeed) {
  const json once = drives({"--noise", "0.02", "--seed", "4", "--samples"});
  EXPECT_EQ(drives({"--noise", "0.02", "--seed", "4", "--samples"}), once);
  EXPECT_NE(drives({"--noise", "0.02", "--seed", "5", "--samples"}), once);
  EXPECT_EQ(drives({"--noise", "0.02", "--seed", "4", "--samples", "--actuation-noise", "0",
                    "--position-noise", "0", "--heading-noise", "0"}),
            drives({"--samples"}))
      << "each kind overrides";
}

TEST_F(FollowCommand, DrivesAPathFromAFile) {
  const std::string file = folder_ / "smooth.csv";
  ASSERT_EQ(wend({"plan", map_, "--start", "0,0", "--goal", "9,4", "--smooth", "-o", file}).code,
            0);
  const Outcome outcome = follow_path(file, {"--controller", "p_moving"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("smoother")));
}

TEST_F(FollowCommand, RejectsStepsToTheSide) {
  const std::string aside = folder_.write("aside.csv",
                                          "x,y,heading,x_m,y_m,yaw\n0.5,0.5,E,0.5,0.5,0\n"
                                          "1.5,0.5,E,1.5,0.5,0\n1.5,1.5,E,1.5,1.5,0\n");
  const Outcome outcome = follow_path(aside);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("the path steps to a side of the robot at cell (1,0)"));
}

/// Open ground of 20 x 20 cells; a cell is a metre.
std::string open_ground(const TemporaryFolder& folder) {
  std::string rows;
  for (int i = 0; i < 20; ++i) rows += std::string(20, '.') + "\n";
  return folder.write("ground.txt", rows);
}

TEST_F(FollowCommand, TakesTheOptionsOfPlannersAsFlags) {
  EXPECT_EQ(follow({"--planner", "astar", "--weight", "2"}).code, 0);
  const Outcome wrong = follow({"--motion-model", "differential"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("the planner 'astar' has no option --motion-model"));
  const Outcome turning =
      wend({"follow", open_ground(folder_), "--start", "4,4,E", "--goal", "12,12,N", "--planner",
            "hybrid_astar", "--motion-model", "differential"});
  EXPECT_EQ(turning.code, 0) << turning.err;
  EXPECT_THAT(turning.out, HasSubstr("controller           stanley\n"));
  const std::string file = folder_.write("line.csv", "# x_m, y_m\n1,1\n8,1\n");
  EXPECT_THAT(follow_path(file, {"--weight", "2"}).err, HasSubstr("no path is planned"));
}

TEST_F(FollowCommand, PlansWhatABicycleCanSteer) {
  const std::string ground = open_ground(folder_);
  const auto drive = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"follow", ground, "--start", "4,4,E", "--goal", "7,6,W", "--planner",
                               "hybrid_astar", "--drivetrain", "bicycle"});
    return wend(std::move(more));
  };
  const Outcome told = drive({});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.err, HasSubstr("the planner's turning radius is 0.49 m"));
  EXPECT_EQ(drive({"--controller", "trajectory"}).code, 0);
  EXPECT_THAT(drive({"--turning-radius", "2"}).err, IsEmpty());
  const Outcome tight = drive({"--turning-radius", "0.2"});
  EXPECT_EQ(tight.code, 2);
  EXPECT_THAT(tight.err, HasSubstr("plan it with --turning-radius 0.49 or more"));
  const Outcome turning = drive({"--motion-model", "differential"});
  EXPECT_EQ(turning.code, 2);
  EXPECT_THAT(turning.err, HasSubstr("which a bicycle cannot do"));
}

TEST_F(FollowCommand, MovesAnOmniRobotToItsSides) {
  const Outcome outcome =
      wend({"follow", open_ground(folder_), "--start", "4,4,E", "--goal", "4,12,E", "--planner",
            "hybrid_astar", "--motion-model", "omni", "--drivetrain", "omni", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_LT(json::parse(outcome.out).at("drives").at(0).at("turned_degrees").get<double>(), 10);
}

TEST_F(FollowCommand, ReachesTheGoalOnlyWhereTheRobotStandsThere) {
  const std::string line = folder_.write("line.csv", "# x_m, y_m\n2,4\n16,4\n");
  for (const char* controller : {"p", "p_moving", "pid", "pure_pursuit", "stanley", "trajectory"}) {
    SCOPED_TRACE(controller);
    const Outcome outcome =
        wend({"follow", open_ground(folder_), "--path", line, "--speed", "2", "--latency", "0.3",
              "--goal-tolerance", "0.05", "--controller", controller, "--format", "json"});
    const json drive = json::parse(outcome.out).at("drives").at(0);
    EXPECT_EQ(outcome.code == 0, drive.at("outcome") == "reached");
    EXPECT_EQ(drive.at("outcome"), "reached");
    EXPECT_LE(drive.at("final_error_m").get<double>(), 0.05);
  }
}

TEST_F(FollowCommand, DrivesALap) {
  const std::string map = folder_.write(
      "open.txt", std::string(20, '.') + "\n" + [] {
        std::string rows;
        for (int i = 0; i < 19; ++i) rows += std::string(20, '.') + "\n";
        return rows;
      }());
  const std::string line = folder_.write("square.csv", "# x_m, y_m\n4,4\n16,4\n16,16\n4,16\n");
  const Outcome outcome =
      wend({"follow", map, "--path", line, "--loop", "--controller", "p", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(json::parse(outcome.out).at("drives").at(0).at("distance_m").get<double>(), 48, 1);
}

TEST_F(FollowCommand, WritesPicturesFilmsAndSamples) {
  const std::string gif = folder_ / "drive.gif";
  const std::string svg = folder_ / "drive.svg";
  const std::string csv = folder_ / "drive.csv";
  const std::string file = folder_ / "drive.json";
  ASSERT_EQ(
      follow({"--smooth", "--film-speed", "8", "-o", gif, "-o", svg, "-o", csv, "-o", file}).code,
      0);
  EXPECT_THAT(bytes_of(gif), StartsWith("GIF89a"));
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
  EXPECT_THAT(bytes_of(csv), StartsWith("controller,time_s,x_m,y_m,yaw,"));
  const json written = json::parse(bytes_of(file));
  EXPECT_TRUE(written.contains("path_smoothed"));
  EXPECT_GT(written.at("drives").at(0).at("samples").at("time_s").size(), 100U);
}

TEST_F(FollowCommand, PlotsWhereGnuplotIs) {
  if (shell("command -v gnuplot").code != 0) GTEST_SKIP() << "gnuplot is missing";
  const std::string plot = folder_ / "drive.svg";
  ASSERT_EQ(follow({"--compare", "--plot", plot}).code, 0);
  EXPECT_THAT(bytes_of(plot), AllOf(HasSubstr("cross-track error, m"), HasSubstr("p_moving")));
}

TEST_F(FollowCommand, RefusesWhatMeansNothing) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--path", "x.csv"}, "leave out --start and --goal"},
      {{"--loop"}, "--loop needs --path"},
      {{"--controller", "pidd"}, "did you mean 'pid'?"},
      {{"--controller", "p,pid"}, "takes exactly one controller"},
      {{"--controller", "p", "--lookahead", "1"}, "has no option --lookahead"},
      {{"--compare=p", "--heading-gain", "1"}, "options follow each controller"},
      {{"--drivetrain", "bicycle", "--controller", "p"}, "turns in place"},
      {{"--rate", "0"}, "rate"},
      {{"--noise", "-1"}, "--noise"},
      {{"--compare", "-o", folder_ / "drive.gif"}, "supports one controller only"},
      {{"--plot", folder_ / "drive.txt"}, "must end in .png, .svg or .pdf"},
  };
  for (const auto& [arguments, wrong] : cases) {
    const Outcome outcome = follow(arguments);
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_THAT(outcome.err, HasSubstr(wrong));
    EXPECT_THAT(outcome.out, IsEmpty()) << wrong;
  }
  EXPECT_EQ(wend({"follow", map_}).code, 2);
}

}  // namespace
}  // namespace wend::test
