// `wend plan --planner hybrid_astar` and what follows it: poses for a robot, smoothing, driving.

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"
#include "wend/render/animation/gif_test_support.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class DriveCommand : public testing::Test {
 protected:
  Outcome run(const std::string& command, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{command,
                                       map_,
                                       "--planner",
                                       "hybrid_astar",
                                       "--footprint",
                                       "1,0.6;-1,0.6;-1,-0.6;1,-0.6",
                                       "--turning-radius",
                                       "3",
                                       "--start",
                                       "3,4,E",
                                       "--goal",
                                       "20,9,N"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return wend(std::move(arguments));
  }

  json plan(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run("plan", arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("map.txt", [] {
    std::string text;
    for (int row = 0; row < 16; ++row) text += std::string(28, '.') + "\n";
    return text;
  }());
};

TEST_F(DriveCommand, WritesThePosesToDriveAndTheirGears) {
  const json planned = plan();
  EXPECT_EQ(planned.at("poses_m").size(), planned.at("gears").size() + 1);
  EXPECT_EQ(planned.at("poses_m").size(), planned.at("path_m").size());
  EXPECT_EQ(planned.at("poses_m").back().size(), 3U);
  const json dense = plan({"--resample", "0.1"});
  EXPECT_EQ(dense.at("path_m"), planned.at("path_m"));
  ASSERT_GT(dense.at("poses_m").size(), 100U);
  for (std::size_t i = 1; i < dense.at("poses_m").size(); ++i) {
    const auto before = dense.at("poses_m").at(i - 1).get<std::vector<double>>();
    const auto after = dense.at("poses_m").at(i).get<std::vector<double>>();
    EXPECT_LT(std::hypot(after[0] - before[0], after[1] - before[1]), 0.16);
  }
}

TEST_F(DriveCommand, DrawsTheTreeOfItsMotions) {
  const std::string svg = folder_ / "tree.svg";
  const std::string plain = folder_ / "plain.svg";
  ASSERT_EQ(run("plan", {"--show", "expansion", "-o", svg}).code, 0);
  ASSERT_EQ(run("plan", {"-o", plain}).code, 0);
  const auto curves_in = [](const std::string& file) {
    const std::string text = bytes_of(file);
    std::size_t count = 0;
    for (std::size_t at = text.find(" C "); at != std::string::npos;
         at = text.find(" C ", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_GT(curves_in(svg), curves_in(plain) + 5);
}

TEST_F(DriveCommand, KeepsTheGrowingTreeAsAFilm) {
  const std::string film = folder_ / "search.gif";
  const json planned = plan({"-o", film, "--speed", "20"});
  const Decoded shown = decoded(bytes_of(film));
  const auto expanded = planned.at("metrics").at("expanded").get<std::size_t>();
  EXPECT_EQ(shown.frames.size(), expanded + 2)
      << "one before each expansion, the end, and the outcome";
  const auto& first = shown.frames.front().image;
  const auto& middle = shown.frames[expanded].image;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < first.size(); ++i) changed += first.values()[i] != middle.values()[i];
  EXPECT_GT(changed, 100U) << "pixels of motions";
  EXPECT_LT(changed, first.size() / 10) << "lines, not cells";
}

TEST_F(DriveCommand, SmoothsByTheSmootherOfDrives) {
  const json smoothed = plan({"--smooth"});
  EXPECT_EQ(smoothed.at("smoothing").at("smoother"), "drive");
  EXPECT_GE(smoothed.at("path_smoothed_metrics").at("smallest_turning_radius_cells").get<double>(),
            3 - 1e-4);
  EXPECT_EQ(smoothed.at("poses_m").size(), smoothed.at("path_smoothed").size());
  EXPECT_THAT(run("plan", {"--simplify"}).err, HasSubstr("--simplify supports grid planners only"));
}

TEST_F(DriveCommand, SmoothsAPathFromAFile) {
  const std::string file = (folder_ / "plan.json").string();
  ASSERT_EQ(run("plan", {"-o", file}).code, 0);
  const Outcome outcome = wend({"smooth", map_, file, "--footprint", "1,0.6;-1,0.6;-1,-0.6;1,-0.6",
                                "--smoother", "drive", "--turning-radius", "3"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("smoother  drive\n"));
}

TEST_F(DriveCommand, IsFollowedToTheGoal) {
  const Outcome outcome = run("follow", {"--margin", "0.3", "--drivetrain", "bicycle",
                                         "--controller", "stanley", "--wheelbase", "1.5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("outcome              reached the goal\n"));
}

}  // namespace
}  // namespace wend::test
