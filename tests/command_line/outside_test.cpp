// `--outside`, from outside: where a robot's disc may hang over the map's edge.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// 20 x 10 free cells.
std::string free_image() {
  std::string text = "P2\n20 10\n255\n";
  for (int i = 0; i < 20 * 10; ++i) text += "255\n";
  return text;
}

std::string free_grid() {
  std::string text;
  for (int row = 0; row < 10; ++row) text += std::string(20, '.') + "\n";
  return text;
}

class Outside : public testing::Test {
 protected:
  /// On the map in metres, 2 x 1 m, for a robot that needs 2.5 cells.
  Outcome in_metres(const std::string& subcommand, std::vector<std::string> more) const {
    more.insert(more.begin(),
                {subcommand, metres_, "--resolution", "0.1", "--robot-radius", "0.25"});
    return wend(std::move(more));
  }

  json json_in_metres(const std::string& subcommand, std::vector<std::string> more) const {
    more.insert(more.end(), {"--format", "json"});
    return json::parse(in_metres(subcommand, std::move(more)).out);
  }

  TemporaryFolder folder_;
  std::string metres_ = folder_.write("metres.pgm", free_image());
  std::string cells_ = folder_.write("cells.txt", free_grid());
};

TEST_F(Outside, IsBlockedOnMapsInMetresAndFreeOnMapsInCells) {
  const json blocked = json_in_metres("info", {});
  EXPECT_EQ(blocked.at("passable"), 16 * 6);
  EXPECT_EQ(blocked.at("outside"), "blocked");
  const json hanging = json_in_metres("info", {"--outside", "free"});
  EXPECT_EQ(hanging.at("passable"), 20 * 10);
  EXPECT_EQ(hanging.at("outside"), "free");
  const std::vector<std::string> in_cells{"info", cells_,     "--robot-radius",
                                          "2.5",  "--format", "json"};
  EXPECT_EQ(json::parse(wend(in_cells).out).at("passable"), 20 * 10);
  std::vector<std::string> told = in_cells;
  told.insert(told.end(), {"--outside", "blocked"});
  EXPECT_EQ(json::parse(wend(told).out).at("passable"), 16 * 6);
  EXPECT_EQ(json_in_metres("info", {"--cells"}).at("outside"), "blocked")
      << "--cells counts in cells; the map is in metres all the same";
}

TEST_F(Outside, IsToldWithTheRobot) {
  EXPECT_THAT(in_metres("info", {}).out,
              HasSubstr("96 cells (48.0 %) for a robot of radius 0.25 m that stays on the map"));
  EXPECT_THAT(in_metres("info", {"--outside", "free"}).out,
              HasSubstr("for a robot of radius 0.25 m that may hang over the map's edge"));
  const Outcome wrong = in_metres("info", {"--outside", "maybe"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, AllOf(HasSubstr("--outside"), HasSubstr("blocked"), HasSubstr("free")));
}

TEST_F(Outside, IsWhyARobotDoesNotFitAtTheEdge) {
  const Outcome plan = in_metres("plan", {"--start", "0.15,0.15", "--goal", "1.5,0.5"});
  EXPECT_EQ(plan.code, 1);
  EXPECT_THAT(plan.err,
              AllOf(HasSubstr("is blocked: the robot would extend beyond the map: the edge is 0.15 "
                              "m away, the robot's radius is 0.25 m (--outside free allows it)"),
                    HasSubstr("The nearest free cell")));
  EXPECT_EQ(in_metres("plan", {"--start", "0.15,0.15", "--goal", "1.5,0.5", "--nearest"}).code, 0);
  const Outcome hanging =
      in_metres("plan", {"--start", "0.15,0.15", "--goal", "1.5,0.5", "--outside", "free"});
  EXPECT_EQ(hanging.code, 0) << hanging.err;
  const Outcome car =
      in_metres("plan", {"--planner", "car", "--start", "0.1,0.5,E", "--goal", "1.5,0.5,E"});
  EXPECT_EQ(car.code, 1);
  EXPECT_THAT(car.err, HasSubstr("the robot would extend beyond the map"));
}

TEST_F(Outside, LimitsHowWideARobotGetsThrough) {
  const json why =
      json_in_metres("explain", {"--start", "0.3,0.5", "--goal", "1.5,0.5"}).at("widest");
  EXPECT_NEAR(why.at("radius_m").get<double>(), 0.35, 1e-9);
  EXPECT_EQ(
      json_in_metres("explain", {"--start", "0.3,0.5", "--goal", "1.5,0.5", "--outside", "free"})
          .at("widest")
          .at("radius_m"),
      nullptr);
}

TEST_F(Outside, CountsInChecksAndInTheCostOfKeepingAway) {
  const std::string path = folder_.write("path.csv", "x_m,y_m\n0.5,0.5\n0.5,0.8\n");
  const json checked = json_in_metres("check", {path});
  EXPECT_EQ(checked.at("collision").at("kind"), "outside");
  EXPECT_NEAR(checked.at("collision").at("along_m").get<double>(), 0.25, 1e-6);
  EXPECT_EQ(checked.at("collision").at("obstacle"), nullptr);
  EXPECT_EQ(in_metres("check", {path, "--outside", "free"}).code, 0);
  const std::vector<std::string> ends{"--start", "0.3,0.5", "--goal", "1.5,0.5"};
  auto keeping = ends;
  keeping.insert(keeping.end(), {"--clearance-distance", "0.5"});
  const double far = json_in_metres("plan", ends).at("cost");
  EXPECT_GT(json_in_metres("plan", keeping).at("cost").get<double>(), far);
  keeping.insert(keeping.end(), {"--outside", "free"});
  EXPECT_EQ(json_in_metres("plan", keeping).at("cost"), far);
}

TEST_F(Outside, IsPartOfWhatAnIndexIsFor) {
  const std::string index = folder_ / "metres.idx";
  ASSERT_EQ(wend({"index", "build", metres_, "--resolution", "0.1", "--robot-radius", "0.25",
                  "--planner", "hub_labels", "-o", index})
                .code,
            0);
  const std::vector<std::string> query{"--start", "0.3,0.5", "--goal", "1.5,0.5", "--index", index};
  EXPECT_EQ(in_metres("plan", query).code, 0);
  auto hanging = query;
  hanging.insert(hanging.end(), {"--outside", "free"});
  const Outcome refused = in_metres("plan", hanging);
  EXPECT_NE(refused.code, 0);
  EXPECT_THAT(refused.err, HasSubstr("the outside of the map"));
}

TEST_F(Outside, IsNothingToARobotWithoutARadius) {
  EXPECT_EQ(
      wend({"plan", metres_, "--resolution", "0.1", "--start", "0.05,0.05", "--goal", "1.95,0.95"})
          .code,
      0);
}

}  // namespace
}  // namespace wend::test
