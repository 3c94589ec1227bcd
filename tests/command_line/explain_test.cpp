// `wend explain` and `wend view`, from outside.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

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
  EXPECT_THAT(outcome.out, AllOf(StartsWith("there is no path from start (1,2) to goal (9,2)\n"),
                                 HasSubstr("with a radius of up to 0.5 cells, narrowest at cell"),
                                 HasSubstr("(5,2)\n"), HasSubstr("--robot-radius 0.5"),
                                 HasSubstr("robot's size      the cause"),
                                 HasSubstr("unknown cells     not the cause"),
                                 HasSubstr("corner rule       not the cause"),
                                 HasSubstr("connectivity      not the cause")));
  // What it says would help, helps.
  EXPECT_EQ(wend({"plan", door_, "--start", "1,2", "--goal", "9,2", "--robot-radius", "0.5"}).code,
            0);
}

TEST_F(ExplainCommand, TellsProgramsToo) {
  const Outcome outcome = explain(
      door_, {"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6", "--format", "json"});
  const json why = json::parse(outcome.out);
  EXPECT_EQ(why.at("schema"), 1);
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
              AllOf(HasSubstr("unknown cells     the cause"), HasSubstr("--unknown free")));
  const std::string corner = folder_.write("corner.txt", "..#..\n###..\n");
  const std::string diagonal = folder_.write("diagonal.txt", "..#\n.#.\n#..\n");
  const Outcome by_corner = explain(diagonal, {"--start", "0,0", "--goal", "2,2"});
  EXPECT_EQ(by_corner.code, 1);
  EXPECT_THAT(by_corner.out,
              AllOf(HasSubstr("corner rule       the cause"), HasSubstr("--corner-rule both")));
  EXPECT_EQ(explain(diagonal, {"--start", "0,0", "--goal", "2,2", "--corner-rule", "both"}).code,
            0);
  const Outcome walled = explain(corner, {"--start", "0,0", "--goal", "4,1"});
  EXPECT_EQ(walled.code, 1);
  EXPECT_THAT(walled.out,
              AllOf(HasSubstr("widest path       none"), HasSubstr("nothing but another map")));
}

/// Two cells that touch with their corners are one component for a point, but not for a disc.
TEST_F(ExplainCommand, CountsWhatThisRobotCanReach) {
  const std::string map = folder_.write("corners.txt", ".#\n#.\n");
  const std::vector<std::string> query{"--start",       "0,0",  "--goal",         "1,1",
                                       "--corner-rule", "both", "--robot-radius", "0.5"};
  const Outcome outcome = explain(map, query);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("start's component 1 cell\n"),
                                 HasSubstr("goal's component  1 cell\n")));
  for (const std::string command : {"plan", "field"}) {
    std::vector<std::string> arguments{command, map};
    arguments.insert(arguments.end(), query.begin(), query.end());
    EXPECT_THAT(wend(arguments).err,
                HasSubstr("the start's connected component has 1 cell, the goal's has 1 cell"));
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
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("the start's connected component has 21 cells"),
                                 HasSubstr("a radius of at most 0.5 cells (--robot-radius 0.5)"),
                                 HasSubstr("wend explain")));
}

TEST_F(ExplainCommand, ExplainsABlockedEnd) {
  const Outcome outcome =
      explain(door_, {"--start", "5,2", "--goal", "9,2", "--robot-radius", "0.6"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("start's component the start (5,2) is blocked"),
                                 HasSubstr("--robot-radius 0.5")));
  const Outcome outside = explain(door_, {"--start", "50,2", "--goal", "9,2"});
  EXPECT_EQ(outside.code, 2);
  EXPECT_THAT(outside.err, HasSubstr("is outside the map"));
}

TEST_F(ExplainCommand, AsksForAnotherEndWhereOneLiesOnAnObstacle) {
  const Outcome goal = explain(door_, {"--start", "1,2", "--goal", "5,0"});
  EXPECT_EQ(goal.code, 1);
  EXPECT_THAT(goal.out, AllOf(HasSubstr("an obstacle lies on goal\n"),
                              HasSubstr("would help        another goal\n")));
  EXPECT_THAT(explain(door_, {"--start", "5,1", "--goal", "5,0"}).out,
              HasSubstr("would help        another start and goal\n"));
}

TEST_F(ExplainCommand, DrawsTheRegions) {
  const std::string svg = folder_ / "why.svg";
  explain(door_, {"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6", "-o", svg});
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
}

/// A solid line would say that there is a path.
TEST_F(ExplainCommand, DashesThePathOfASmallerRobotAndSaysForWhich) {
  const std::vector<std::string> query{"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6"};
  const std::string out = explain(door_, query).out;
  EXPECT_THAT(out, AllOf(HasSubstr("◇ path for a robot of 0.5 cells"), HasSubstr("! narrowest"),
                         HasSubstr("s start's component"), HasSubstr("g goal's component"),
                         Not(HasSubstr("→ path"))));
  std::vector<std::string> drawn = query;
  const std::string svg = folder_ / "why.svg";
  drawn.insert(drawn.end(), {"-o", svg});
  explain(door_, drawn);
  EXPECT_THAT(bytes_of(svg), HasSubstr("stroke-dasharray"));
  const Outcome fits = explain(door_, {"--start", "1,2", "--goal", "9,2"});
  EXPECT_THAT(fits.out, AllOf(HasSubstr("→ path"), Not(HasSubstr("path for a robot"))));
}

TEST_F(ExplainCommand, LabelsThePathByWhatWouldMakeIt) {
  const std::string unknown = folder_.write("unknown.txt", "..?..\n..?..\n");
  EXPECT_THAT(explain(unknown, {"--start", "0,0", "--goal", "4,1"}).out,
              AllOf(HasSubstr("◇ path through unknown cells"), Not(HasSubstr("! narrowest"))));
  const std::string diagonal = folder_.write("diagonal.txt", "..#\n.#.\n#..\n");
  EXPECT_THAT(explain(diagonal, {"--start", "0,0", "--goal", "2,2"}).out,
              HasSubstr("◇ path between touching obstacles"));
}

TEST_F(ExplainCommand, MarksTheNearestFreeCellOfABlockedEnd) {
  const Outcome outcome =
      explain(door_, {"--start", "5,2", "--goal", "9,2", "--robot-radius", "0.6"});
  EXPECT_THAT(outcome.out, HasSubstr("N nearest free cell"));
  EXPECT_THAT(wend({"plan", door_, "--start", "5,2", "--goal", "9,2", "--robot-radius", "0.6"}).err,
              HasSubstr("The nearest free cell that is connected to the goal is (6,2)"));
  EXPECT_THAT(outcome.out, HasSubstr("SN◇◇Gg"));
}

TEST_F(ExplainCommand, DashesThePathThatPlanDashesOfAFailure) {
  const std::vector<std::string> query{"--start", "1,2", "--goal", "9,2", "--robot-radius", "0.6"};
  const std::string why = folder_ / "why.svg";
  const std::string failed = folder_ / "failed.svg";
  for (const auto& [command, file] : {std::pair("explain", why), std::pair("plan", failed)}) {
    std::vector<std::string> arguments{command, door_, "-o", file};
    arguments.insert(arguments.end(), query.begin(), query.end());
    EXPECT_EQ(wend(arguments).code, 1);
  }
  // The picture of plan has a heading and the reason in words besides.
  const std::string dashes = "stroke-dasharray";
  EXPECT_THAT(bytes_of(why), HasSubstr(dashes));
  EXPECT_THAT(bytes_of(failed), HasSubstr(dashes));
}

/// Characters, not bytes, of the widest line.
std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::size_t width = 0;
  for (const char letter : text) {
    const bool continues = (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U;
    if (letter == '\n') {
      widest = std::max(widest, width);
      width = 0;
    } else if (!continues) {
      ++width;
    }
  }
  return std::max(widest, width);
}

/// A corridor whose numbers take more columns than there are, and coordinates that are long.
TEST_F(ExplainCommand, FitsIntoEightyColumnsAsViewAndFieldDo) {
  const std::string lane =
      folder_.write("lane.txt", std::string(78, '.') + "\n" + std::string(78, '.') + "\n");
  const std::vector<std::string> ends{"--start", "0,0", "--goal", "77,1"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    return wend(std::move(arguments)).out;
  };
  const std::string field = with({"field", lane});
  EXPECT_LE(widest_line(field), 80U) << field;
  EXPECT_THAT(field, AllOf(HasSubstr("x from 0 to "), HasSubstr(" to 77\n")));
  const std::string clearance = wend({"view", lane, "--show", "clearance,terrain"}).out;
  EXPECT_LE(widest_line(clearance), 80U) << clearance;
  EXPECT_LE(widest_line(with({"explain", lane})), 80U);
  const std::string unknown = folder_.write("unknown_corner.txt", "..#..\n.#?..\n#??..\n");
  const std::string why = explain(unknown, {"--start", "0,0", "--goal", "4,2"}).out;
  EXPECT_LE(widest_line(why), 80U) << why;
  const std::string name = folder_.write(std::string(90, 'n') + ".txt", "...\n");
  EXPECT_THAT(wend({"view", name}).out, StartsWith(std::string(90, 'n') + ".txt\n"));
}

/// Each number stands where it stood, in a band of its own.
TEST_F(ExplainCommand, FoldsGridsBetweenCells) {
  std::string row(60, '.');
  row[0] = '#';
  const std::string lane = folder_.write("wall.txt", row + "\n");
  EXPECT_EQ(wend({"view", lane, "--show", "clearance"}).out,
            "clearance in cells\n"
            "x from 0 to 15\n"
            "   #  0.5  1.5  2.5  3.5  4.5  5.5  6.5  7.5  8.5  9.5 10.5 11.5 12.5 13.5 14.5\n"
            "x from 16 to 31\n"
            "15.5 16.5 17.5 18.5 19.5 20.5 21.5 22.5 23.5 24.5 25.5 26.5 27.5 28.5 29.5 30.5\n"
            "x from 32 to 47\n"
            "31.5 32.5 33.5 34.5 35.5 36.5 37.5 38.5 39.5 40.5 41.5 42.5 43.5 44.5 45.5 46.5\n"
            "x from 48 to 59\n"
            "47.5 48.5 49.5 50.5 51.5 52.5 53.5 54.5 55.5 56.5 57.5 58.5\n\n");
}

TEST_F(ExplainCommand, CountsInMetresWhereTheMapDoes) {
  const std::string office = folder_ / "office.yaml";
  ASSERT_EQ(wend({"generate", "office", "--size", "160x100", "--seed", "7", "-o", office}).code, 0);
  const std::string metres =
      wend({"view", office, "--show", "clearance", "--picture", "always"}).out;
  EXPECT_THAT(metres, AllOf(HasSubstr("clearance in m\n"), Not(HasSubstr("in cells"))));
  EXPECT_THAT(wend({"view", door_, "--show", "clearance"}).out, HasSubstr("clearance in cells\n"));
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
  const Outcome left = view({far});
  EXPECT_EQ(left.code, 1);
  EXPECT_THAT(left.out, IsEmpty());
  EXPECT_THAT(left.err, HasSubstr("at (11,2.5), cell (10,2), it leaves the map"));
  EXPECT_THAT(error_of({"--show", "expansion"}), HasSubstr("wend plan --show"));
  EXPECT_THAT(error_of({"--style", "dim"}), HasSubstr("light, dark, print"));
  EXPECT_THAT(error_of({folder_ / "none.csv"}), HasSubstr("none.csv"));
  const std::string path = path_file("a.csv");
  EXPECT_THAT(error_of({"-o", folder_ / "door.gif"}), HasSubstr("must end in"));
}

}  // namespace
}  // namespace wend::test
