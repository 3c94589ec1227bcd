// `wend check`, from outside.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* kSmallYard =
    ".......\n"
    ".......\n"
    "...#...\n"
    ".......\n"
    "......#\n"
    ".....#.\n";

class CheckCommand : public testing::Test {
 protected:
  Outcome check(const std::string& path, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"check", map_, path});
    return wend(std::move(more));
  }

  std::string waypoints(const std::string& lines) const {
    return folder_.write("path.csv", "x_grid,y_grid,x_m,y_m,yaw\n" + lines);
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kSmallYard);
};

TEST_F(CheckCommand, SaysThatAFreePathIsAndMeasuresIt) {
  const Outcome outcome = check(waypoints("0.5,0.5,0,0,0\n6.5,0.5,0,0,0\n6.5,2.5,0,0,0\n"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("free: the path is clear of obstacles\n"),
                                 HasSubstr("length, cells                   8.00\n"),
                                 HasSubstr("turning, degrees                  90\n"),
                                 HasSubstr("smallest clearance, cells       1.50\n")));
}

constexpr const char* kLong = "0.9,0.4;-0.9,0.4;-0.9,-0.4;0.9,-0.4";

TEST_F(CheckCommand, SweepsAPolygonAlongThePathAndWhereItTurns) {
  const std::string straight = waypoints("1,1.5,0,0,0\n6,1.5,0,0,0\n");
  const Outcome free = check(straight, {"--footprint", kLong});
  EXPECT_EQ(free.code, 0) << free.err;
  EXPECT_THAT(free.out, HasSubstr("free: the robot's footprint is clear of every obstacle"));
  EXPECT_EQ(check(straight, {"--footprint", "disc:0.9"}).code, 1);

  const std::string bent = waypoints("1,1.5,0,0,0\n3.5,1.5,0,0,0\n3.5,0.9,0,0,0\n");
  const Outcome turning = check(bent, {"--footprint", kLong, "--format", "json"});
  EXPECT_EQ(turning.code, 1);
  EXPECT_THAT(turning.err, HasSubstr("it overlaps an obstacle with its footprint"));
  const json collision = json::parse(turning.out).at("collision");
  EXPECT_EQ(collision.at("kind"), "overlaps");
  EXPECT_NEAR(collision.at("along_cells"), 2.5, 1e-6);
  EXPECT_EQ(collision.at("obstacle"), json::parse("[3,2]"));
}

TEST_F(CheckCommand, SaysWhereAPathFirstCollides) {
  const std::string path = waypoints("0.5,2.5,0,0,0\n6.5,2.5,0,0,0\n");
  const Outcome outcome = check(path);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, StartsWith("wend: the path is not free: after 2.5 cells, at (3,2.5), "));
  EXPECT_THAT(outcome.err, HasSubstr(", it enters an obstacle: the one at cell (3,2)\n"));
  EXPECT_THAT(outcome.out, HasSubstr("✗"));
  const Outcome with_radius = check(path, {"--robot-radius", "0.5", "--format", "json"});
  EXPECT_EQ(with_radius.code, 1);
  const json collision = json::parse(with_radius.out).at("collision");
  EXPECT_EQ(collision.at("kind"), "too_close");
  EXPECT_NEAR(collision.at("along_cells").get<double>(), 2, 1e-6);
  EXPECT_EQ(collision.at("obstacle"), json::parse("[3,2]"));
}

TEST_F(CheckCommand, LetsARobotSqueezeIfTheCornerRuleDoes) {
  const std::string path = waypoints("5.5,4.5,0,0,0\n6.5,5.5,0,0,0\n");
  EXPECT_THAT(check(path).err, HasSubstr("passes between two obstacles"));
  EXPECT_EQ(check(path, {"--corner-rule", "both"}).code, 0);
}

TEST_F(CheckCommand, MarksTheCollisionInPicturesAndWritesTheJson) {
  const std::string path = waypoints("0.5,2.5,0,0,0\n6.5,2.5,0,0,0\n");
  const std::string svg = folder_ / "collision.svg";
  const std::string file = folder_ / "check.json";
  EXPECT_EQ(check(path, {"-o", svg, "-o", file}).code, 1);
  EXPECT_THAT(bytes_of(svg), HasSubstr("<svg"));
  EXPECT_EQ(json::parse(bytes_of(file)).at("free"), false);
}

TEST_F(CheckCommand, SaysSoOfPathsThatLeaveTheMap) {
  const std::string path = folder_.write("out.csv", "x,y,x_m,y_m\n5,0,0,0\n6,0,0,0\n9,0,0,0\n");
  const Outcome outcome = check(path);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("it leaves the map"));
}

/// And so do the other commands that read one.
TEST_F(CheckCommand, SaysTheSameOnAllFourSidesAndInEveryCommand) {
  for (const char* out : {"-1,1", "9,1", "2,-1", "2,9", "1e9,1", "-1e9,1"}) {
    const std::string point(out);
    const std::string path = waypoints("2,1,0,0,0\n" + point + ",0,0,0\n");
    const Outcome checked = check(path, {"--picture", "never"});
    EXPECT_EQ(checked.code, 1) << out;
    EXPECT_THAT(checked.err, HasSubstr("it leaves the map")) << out;
    for (const char* command : {"smooth", "view"}) {
      const Outcome outcome = wend({command, map_, path});
      EXPECT_EQ(outcome.code, 1) << command << out;
      EXPECT_EQ(outcome.err, checked.err) << command << out;
    }
    const Outcome followed = wend({"follow", map_, "--path", path});
    EXPECT_EQ(followed.code, 1) << out;
    EXPECT_EQ(followed.err, checked.err) << out;
  }
  const std::string cells = folder_.write("out.csv", "x,y,x_m,y_m\n1,0,0,0\n0,0,0,0\n-2,0,0,0\n");
  EXPECT_THAT(check(cells).err, HasSubstr("it leaves the map"));
  const Outcome far = check(waypoints("2,1,0,0,0\n1e9,1,0,0,0\n"), {"--format", "json"});
  EXPECT_EQ(json::parse(far.out).at("metrics"), nullptr) << "too far off the map to be measured";
}

TEST_F(CheckCommand, ChecksTheSmoothedPathOfAPlan) {
  const std::string path =
      folder_.write("plan.json", R"({"path":[[0,2],[6,2]],"path_smoothed":[[0.5,0.5],[6.5,0.5]]})");
  EXPECT_EQ(check(path).code, 0);
}

TEST_F(CheckCommand, RefusesWhatIsNoPath) {
  const Outcome outcome = check(folder_.write("bad.csv", "x_m,y_m\n1,two\n"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("bad.csv:2: y_m must be a finite number, not 'two'"));
  EXPECT_EQ(check(folder_ / "missing.csv").code, 2);
  EXPECT_EQ(check(map_, {"-o", map_}).code, 2);
}

}  // namespace
}  // namespace wend::test
