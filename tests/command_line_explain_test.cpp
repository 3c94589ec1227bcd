// `wend explain` and `wend view`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Two rooms with a door one cell wide.
constexpr const char* kDoor =
    ".....#.....\n"
    ".....#.....\n"
    "...........\n"
    ".....#.....\n"
    ".....#.....\n";

class ExplainCommand : public testing::Test {
 protected:
  Outcome explain(const std::string& map, std::vector<std::string> more) const {
    more.insert(more.begin(), {"explain", map});
    return wend(std::move(more));
  }

  TemporaryFolder folder_;
  std::string door_ = folder_.write("door.txt", kDoor);
};

TEST_F(ExplainCommand, FindsTheDoorThatIsTooNarrow) {
  const std::vector<std::string> query{"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6"};
  const Outcome outcome = explain(door_, query);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(
      outcome.out,
      AllOf(StartsWith("no path joins start (1,2) and goal (9,2)\n"),
            HasSubstr("with a radius of up to 0.5 cells, narrowest at cell (5,2)"),
            HasSubstr("--robot-radius 0.5"), HasSubstr("robot's size    the cause"),
            HasSubstr("unknown cells   not the cause"), HasSubstr("corner rule     not the cause"),
            HasSubstr("connectivity    not the cause")));
  // What it says would help, helps.
  EXPECT_EQ(wend({"plan", door_, "--start", "1,2", "--goal", "9,2", "--robot-radius", "0.5"}).code,
            0);
}

TEST_F(ExplainCommand, TellsProgramsToo) {
  const Outcome outcome = explain(
      door_, {"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6", "--format", "json"});
  const json why = json::parse(outcome.out);
  EXPECT_EQ(why.at("status"), "unreachable");
  EXPECT_EQ(why.at("widest").at("radius_cells"), 0.5);
  EXPECT_EQ(why.at("widest").at("narrowest"), json::array({5.5, 2.5}));
  EXPECT_TRUE(why.at("widest").at("radius_m").is_null());
  ASSERT_EQ(why.at("ways").size(), 1U);
  EXPECT_EQ(why.at("ways")[0].at("smaller_robot"), true);
  EXPECT_EQ(why.at("ways")[0].at("unknown_free"), false);
}

TEST_F(ExplainCommand, NamesUnknownCellsAndTheCornerRule) {
  const std::string unknown = folder_.write("unknown.txt", "..?..\n..?..\n");
  const Outcome by_unknown = explain(unknown, {"--start", "0,0", "--goal", "4,1"});
  EXPECT_EQ(by_unknown.code, 1);
  EXPECT_THAT(by_unknown.out,
              AllOf(HasSubstr("unknown cells   the cause"), HasSubstr("--unknown free")));
  const std::string corner = folder_.write("corner.txt", "..#..\n###..\n");
  const std::string diagonal = folder_.write("diagonal.txt", "..#\n.#.\n#..\n");
  const Outcome by_corner = explain(diagonal, {"--start", "0,0", "--goal", "2,2"});
  EXPECT_EQ(by_corner.code, 1);
  EXPECT_THAT(by_corner.out,
              AllOf(HasSubstr("corner rule     the cause"), HasSubstr("--corner-rule both")));
  EXPECT_EQ(explain(diagonal, {"--start", "0,0", "--goal", "2,2", "--corner-rule", "both"}).code,
            0);
  const Outcome walled = explain(corner, {"--start", "0,0", "--goal", "4,1"});
  EXPECT_EQ(walled.code, 1);
  EXPECT_THAT(walled.out,
              AllOf(HasSubstr("widest path     none"), HasSubstr("nothing but another map")));
}

/// Two cells that touch with their corners are one region for a point, but not for a disc.
TEST_F(ExplainCommand, CountsWhatThisRobotCanReach) {
  const std::string map = folder_.write("corners.txt", ".#\n#.\n");
  const std::vector<std::string> query{"--start",       "0,0",  "--goal",         "1,1",
                                       "--corner-rule", "both", "--robot-radius", "0.5"};
  const Outcome outcome = explain(map, query);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("start's region  1 cell\n"), HasSubstr("goal's region   1 cell\n")));
  for (const std::string command : {"plan", "field"}) {
    std::vector<std::string> arguments{command, map};
    arguments.insert(arguments.end(), query.begin(), query.end());
    EXPECT_THAT(wend(arguments).err,
                HasSubstr("the start's region has 1 cell, the goal's has 1 cell"));
  }
}

TEST_F(ExplainCommand, SaysHowWideTheWayIsWhereThereIsOne) {
  const Outcome outcome = explain(door_, {"--start", "1,2", "--goal", "9,2"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("there is a path from (1,2) to (9,2)\n"),
                    HasSubstr("radius of up to 0.5 cells"), Not(HasSubstr("would help"))));
}

TEST_F(ExplainCommand, IsWhatPlanSaysInOneSentence) {
  const Outcome outcome =
      wend({"plan", door_, "--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the start's region has 21 cells"),
                                 HasSubstr("a radius of at most 0.5 cells (--robot-radius 0.5)"),
                                 HasSubstr("wend explain")));
}

TEST_F(ExplainCommand, ExplainsABlockedEnd) {
  const Outcome outcome =
      explain(door_, {"--start", "5,2", "--goal", "9,2", "--robot-radius", "0.6"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("start's region  the start (5,2) is blocked"),
                                 HasSubstr("--robot-radius 0.5")));
  const Outcome outside = explain(door_, {"--start", "50,2", "--goal", "9,2"});
  EXPECT_EQ(outside.code, 2);
  EXPECT_THAT(outside.err, HasSubstr("lies outside the map"));
}

TEST_F(ExplainCommand, AsksForAnotherEndWhereOneLiesOnAnObstacle) {
  const Outcome goal = explain(door_, {"--start", "1,2", "--goal", "5,0"});
  EXPECT_EQ(goal.code, 1);
  EXPECT_THAT(goal.out, AllOf(HasSubstr("an obstacle lies on goal\n"),
                              HasSubstr("would help      another goal\n")));
  EXPECT_THAT(explain(door_, {"--start", "5,1", "--goal", "5,0"}).out,
              HasSubstr("would help      another start and goal\n"));
}

TEST_F(ExplainCommand, DrawsTheRegions) {
  const std::string svg = folder_ / "why.svg";
  explain(door_, {"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6", "-o", svg});
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
}

class ViewCommand : public ExplainCommand {
 protected:
  Outcome view(std::vector<std::string> more) const {
    more.insert(more.begin(), {"view", door_});
    return wend(std::move(more));
  }

  std::string path_file(const std::string& name) const {
    const std::string file = folder_ / name;
    EXPECT_EQ(wend({"plan", door_, "--start", "1,2", "--goal", "9,2", "-o", file}).code, 0);
    return file;
  }
};

TEST_F(ViewCommand, ShowsAMapAndThePathsOnIt) {
  const Outcome map = view({});
  EXPECT_EQ(map.code, 0) << map.err;
  EXPECT_THAT(map.out,
              AllOf(StartsWith("door.txt (11 x 5 cells)\n.....#.....\n"), HasSubstr("# obstacle")));
  const Outcome paths = view({path_file("a.csv"), path_file("b.json")});
  EXPECT_EQ(paths.code, 0) << paths.err;
  EXPECT_THAT(paths.out, AllOf(HasSubstr("a.csv (length 8 cells, clearance 0.5 cells)\n"),
                               HasSubstr("b.json (length"), HasSubstr(".S→→→→→→→G.")));
}

TEST_F(ViewCommand, ShowsTheNumbersOfLayers) {
  const Outcome outcome = view({"--show", "clearance"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("clearance in cells\n"
                                      "4.50 3.50 2.50 1.50 0.50    # 0.50"));
  EXPECT_THAT(view({"--show", "clearance", "--picture", "never"}).out, IsEmpty());
}

TEST_F(ViewCommand, WritesPanelsForPathsMapsLayersAndStyles) {
  const std::string other = folder_.write("other.txt", "..\n..\n");
  const std::string file = folder_ / "all.svg";
  const Outcome outcome = view({path_file("a.csv"), "--beside", other, "--show", "clearance",
                                "--style", "light,dark,print", "-o", file});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(bytes_of(file), HasSubstr("<svg"));
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("a.csv"), HasSubstr("clearance in cells"), HasSubstr("other.txt")));
}

TEST_F(ViewCommand, RefusesWhatDoesNotFit) {
  const auto error_of = [&](std::vector<std::string> arguments) {
    const Outcome outcome = view(std::move(arguments));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  const std::string far = folder_.write("far.csv", "x,y,x_m,y_m\n1,2,1.5,2.5\n90,2,90.5,2.5\n");
  EXPECT_THAT(error_of({far}),
              AllOf(HasSubstr("far.csv"), HasSubstr("(90,2)"), HasSubstr("11 x 5 cells")));
  EXPECT_THAT(error_of({"--show", "expansion"}), HasSubstr("wend plan --show"));
  EXPECT_THAT(error_of({"--style", "dim"}), HasSubstr("light, dark, print"));
  EXPECT_THAT(error_of({folder_ / "none.csv"}), HasSubstr("none.csv"));
  const std::string path = path_file("a.csv");
  EXPECT_THAT(error_of({"-o", folder_ / "door.gif"}), HasSubstr("must end in"));
}

}  // namespace
}  // namespace wend::test
