// `wend plan --planner lattice`, from outside.

#include <gmock/gmock.h>

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
using testing::Not;
using testing::StartsWith;

constexpr std::string_view kRobot = R"(resolution_m: 1
numberofangles: 4
totalnumberofprimitives: 5
primID: 0
startangle_c: 0
endpose_c: 1 0 0
additionalactioncostmult: 1
intermediateposes: 2
0 0 0
1 0 0
primID: 1
startangle_c: 0
endpose_c: 2 2 1
additionalactioncostmult: 1
intermediateposes: 3
0 0 0
1.4142 0.5858 0.7854
2 2 1.5708
primID: 0
startangle_c: 1
endpose_c: 0 1 1
additionalactioncostmult: 1
intermediateposes: 2
0 0 1.5708
0 1 1.5708
primID: 2
startangle_c: 1
endpose_c: 1 0 1
additionalactioncostmult: 3
intermediateposes: 2
0 0 1.5708
1 0 1.5708
primID: 3
startangle_c: 1
endpose_c: 0 0 2
additionalactioncostmult: 1
intermediateposes: 2
0 0 1.5708
0 0 3.1416
)";

class LatticeCommand : public testing::Test {
 protected:
  Outcome plan(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"plan", map_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return wend(std::move(arguments));
  }

  TemporaryFolder folder_;
  // Row 0 is at the top, so the robot turns from +x to +y to the right.
  std::string map_ = folder_.write("map.txt", "........\n........\n.....#..\n........\n........\n");
  std::string robot_ = folder_.write("robot.mprim", std::string(kRobot));
};

TEST_F(LatticeCommand, DrivesByThePrimitivesOfAFile) {
  const Outcome outcome = plan({"--primitives", robot_, "--start", "0,0,E", "--goal", "4,3,W"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("Start (0.5,0.5,E)\n"
                                     "Go 2 x FWD -> (2.5,0.5,E)\n"
                                     "Go FWD_RIGHT -> (4.5,2.5,S)\n"
                                     "Go FWD -> (4.5,3.5,S)\n"
                                     "Go TURN_RIGHT -> (4.5,3.5,W)\n"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("planner   lattice\n"), HasSubstr("cost      7.71239\n"),
                                 HasSubstr("optimal")));
}

TEST_F(LatticeCommand, StepsAsideWhereTheFileLetsIt) {
  const Outcome outcome = plan({"--primitives", robot_, "--start", "2,1,S", "--goal", "3,1,S"});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("Go SIDE_LEFT -> (3.5,1.5,S)\n"),
                                 HasSubstr("cost      3\n"), HasSubstr("0 turns")));
}

TEST_F(LatticeCommand, DrivesBackOnlyWhereItIsAsked) {
  const std::vector<std::string> ends{"--primitives", robot_,   "--start",
                                      "4,0,E",        "--goal", "2,0,E"};
  const Outcome ahead = plan(ends);
  EXPECT_EQ(ahead.code, 1);
  EXPECT_THAT(ahead.err, HasSubstr("no sequence of motion primitives leads from the start"));
  std::vector<std::string> back = ends;
  back.emplace_back("--ways-back");
  EXPECT_THAT(plan(back).out,
              AllOf(HasSubstr("Go 2 x REV -> (2.5,0.5,E)\n"),
                    HasSubstr("steps     2: 0 turns, 2 in reverse"), HasSubstr("cost      4\n")));
}

TEST_F(LatticeCommand, HasJsonWithPoses) {
  const Outcome outcome = plan({"--planner", "lattice", "--start", "0,0,E", "--goal", "2,1,any",
                                "--turning-radius", "2", "--format", "json"});
  const json plan = json::parse(outcome.out);
  EXPECT_EQ(plan.at("status"), "found");
  EXPECT_EQ(plan.at("path").front(), json::array({0.5, 0.5}));
  EXPECT_EQ(plan.at("path").back(), json::array({2.5, 1.5}));
  EXPECT_EQ(plan.at("headings").front(), "E");
  EXPECT_EQ(plan.at("moves").size() + 1, plan.at("path").size());
  EXPECT_EQ(plan.at("steps"), plan.at("moves").size());
  EXPECT_FALSE(plan.contains("turning_radius_m")) << "that of a car";
  EXPECT_EQ(plan.at("goal_shift").at("cells"), 0);
}

TEST_F(LatticeCommand, WritesAPathThatCheckFindsFree) {
  const std::string path = (folder_ / "path.csv").string();
  const std::string robot = "1.2,0.4;-0.4,0.4;-0.4,-0.4;1.2,-0.4";
  const Outcome planned = plan({"--planner", "lattice", "--footprint", robot, "--start", "1,1,E",
                                "--goal", "6,3,S", "-o", path, "-o", (folder_ / "p.png").string()});
  ASSERT_EQ(planned.code, 0) << planned.err;
  const Outcome checked = wend({"check", map_, path, "--footprint", robot});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("free: the robot's footprint is clear"));
  const Outcome larger = wend({"check", map_, path, "--footprint", "disc:2.9"});
  EXPECT_EQ(larger.code, 1) << "it can fail";
}

TEST_F(LatticeCommand, MovesAStartWhereTheRobotDoesNotFit) {
  const std::vector<std::string> ends{"--planner", "lattice", "--start",
                                      "5,2,E",     "--goal",  "2,1,any"};
  const Outcome blocked = plan(ends);
  EXPECT_EQ(blocked.code, 1);
  std::vector<std::string> nearest = ends;
  nearest.emplace_back("--nearest");
  const Outcome moved = plan(nearest);
  EXPECT_EQ(moved.code, 0) << moved.err;
  EXPECT_THAT(moved.err, HasSubstr("the robot does not fit at the start (5.5,2.5,E)"));
  EXPECT_THAT(moved.err, HasSubstr("; planning from cell (5,1), 1 cell away"));
}

TEST_F(LatticeCommand, RefusesARobotThatIsLargerThanTheMap) {
  const Outcome outcome = plan(
      {"--planner", "lattice", "--footprint", "disc:1e9", "--start", "0,0,E", "--goal", "2,1,any"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("is larger than the map of 8 x 5 cells"));
}

TEST_F(LatticeCommand, TracesAndStepsThroughItsSearch) {
  const std::string trace = (folder_ / "search.trace.json").string();
  const Outcome traced = plan(
      {"--planner", "lattice", "--start", "0,0,E", "--goal", "3,1", "--trace", trace, "--verbose"});
  EXPECT_EQ(traced.code, 0);
  EXPECT_THAT(traced.err, AllOf(HasSubstr("expand (0,0,E) f="), HasSubstr("deg) from (")));
  const json events = json::parse(bytes_of(folder_ / "search.trace.json")).at("events");
  EXPECT_THAT(events.dump(), AllOf(HasSubstr("\"heading\":\"E\""), HasSubstr("\"type\":\"end\"")));
}

TEST_F(LatticeCommand, SaysWhatIsWrong) {
  const std::vector<std::string> ends{"--start", "0,0,E", "--goal", "2,1"};
  const auto error_of = [&](std::vector<std::string> more) {
    more.insert(more.end(), ends.begin(), ends.end());
    const Outcome outcome = plan(more);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_THAT(error_of({"--planner", "car", "--primitives", robot_}),
              HasSubstr("--primitives changes nothing for the planner car: use --planner lattice"));
  EXPECT_THAT(error_of({"--primitives", (folder_ / "no.mprim").string()}),
              HasSubstr("no.mprim: cannot be opened"));
  const std::string half = folder_.write("half.mprim", std::string(kRobot.substr(0, 200)));
  EXPECT_THAT(error_of({"--primitives", half}), HasSubstr("half.mprim:"));
  EXPECT_THAT(error_of({"--primitives", robot_, "--turning-radius", "3"}),
              HasSubstr("turning_radius changes nothing: the robot has motion primitives"));
  EXPECT_THAT(error_of({"--planner", "lattice", "--ways-back"}),
              HasSubstr("ways_back changes nothing without motion primitives"));
  EXPECT_THAT(error_of({"--planner", "lattice", "--simplify"}),
              HasSubstr("--simplify supports grid planners only"));
}

}  // namespace
}  // namespace wend::test
