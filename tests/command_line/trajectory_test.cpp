// `--trajectory` of plan, smooth and follow, and the controller `trajectory`, from outside.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/command_line/corridor_grid.hpp"
#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class TrajectoryCommand : public testing::Test {
 protected:
  Outcome plan(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"plan", map_, "--start", "0,0", "--goal", "9,4"});
    return wend(std::move(more));
  }

  Outcome follow(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"follow", map_, "--start", "0,0", "--goal", "9,4"});
    return wend(std::move(more));
  }

  /// The numbers of the rows of a file.
  std::vector<std::vector<double>> rows_of(const std::string& file) const {
    std::istringstream text(bytes_of(file));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "t,x,y,heading,v,w");
    std::vector<std::vector<double>> rows;
    while (std::getline(text, line)) {
      std::istringstream fields(line);
      rows.emplace_back();
      for (std::string field; std::getline(fields, field, ',');) {
        rows.back().push_back(std::stod(field));
      }
    }
    return rows;
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kCorridorGrid);
  std::string csv_ = folder_ / "trajectory.csv";
  std::string json_ = folder_ / "trajectory.json";
};

TEST_F(TrajectoryCommand, WritesAPlansTrajectoryWithinTheLimits) {
  const Outcome outcome = plan({"--trajectory", csv_, "--velocity-limits", "speed=2,turn_rate=3"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("duration  "));
  const auto rows = rows_of(csv_);
  ASSERT_GT(rows.size(), 10U);
  EXPECT_EQ(rows.front(), (std::vector<double>{0, 0.5, 0.5, 0, 0, 0}));
  EXPECT_EQ(rows[3][0], 0.15);
  EXPECT_NEAR(rows.back()[1], 9.5, 1e-9);
  EXPECT_NEAR(rows.back()[2], 4.5, 1e-9);
  double fastest = 0;
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 6U);
    fastest = std::max(fastest, row[4]);
    EXPECT_LE(std::abs(row[5]), 3 + 1e-9);
  }
  EXPECT_NEAR(fastest, 2, 1e-9);
}

TEST_F(TrajectoryCommand, JsonHasTheSameNumbers) {
  const std::vector<std::string> smooth{"--smooth", "--trajectory", json_, "--format", "json"};
  const json plan_report = json::parse(plan(smooth).out);
  const json trajectory = json::parse(bytes_of(json_));
  EXPECT_EQ(trajectory.at("schema"), 1);
  EXPECT_EQ(trajectory.at("trajectory"), plan_report.at("trajectory"));
  const json& samples = trajectory.at("trajectory").at("samples");
  EXPECT_EQ(samples.at("time_s").back(), trajectory.at("trajectory").at("duration_s"));
  EXPECT_EQ(samples.at("yaw").size(), samples.at("time_s").size());
  EXPECT_EQ(trajectory.at("trajectory").at("limits").at("lateral_acceleration"), 1);
  EXPECT_FALSE(json::parse(plan({"--format", "json"}).out).contains("trajectory"));
}

TEST_F(TrajectoryCommand, SmoothWritesOneTooAndRoundsCornersAsAsked) {
  const std::string path = folder_ / "plan.csv";
  ASSERT_EQ(plan({"-o", path}).code, 0);
  const auto duration = [&](const std::string& window) {
    const Outcome outcome = wend({"smooth", map_, path, "--smoother", "none", "--trajectory", json_,
                                  "--corner-rounding", window, "--format", "json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out).at("trajectory").at("duration_s").get<double>();
  };
  EXPECT_LT(duration("0.2"), duration("0"));
}

TEST_F(TrajectoryCommand, OfAFailedPlanSaysWhy) {
  const Outcome outcome =
      wend({"plan", map_, "--start", "0,0", "--goal", "99,99", "--trajectory", csv_, "-o", json_});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(bytes_of(csv_), AllOf(StartsWith("# no path: goal_outside: "),
                                    testing::EndsWith("\nt,x,y,heading,v,w\n")));
}

TEST_F(TrajectoryCommand, RefusesWhatMakesNoSense) {
  const auto refuses = [&](const std::vector<std::string>& flags, const std::string& why) {
    const Outcome outcome = plan(flags);
    EXPECT_EQ(outcome.code, 2) << why;
    EXPECT_THAT(outcome.err, HasSubstr(why));
  };
  refuses({"--trajectory", folder_ / "a.png"}, "must end with .csv or .json");
  refuses({"--trajectory", folder_ / "none" / "a.csv"}, "does not exist");
  refuses({"--trajectory", csv_, "-o", csv_}, "-o writes this file, too");
  refuses({"--trajectory", csv_, "--velocity-limits", "speed=0"}, "option 'speed'");
  refuses({"--trajectory", csv_, "--velocity-limits", "pace=1"}, "unknown option 'pace'");
  refuses({"--trajectory", csv_, "--trajectory-period", "0"}, "--trajectory-period");
  refuses({"--velocity-limits", "speed=1"}, "add --trajectory FILE");
  refuses({"--trajectory-period", "1"}, "add --trajectory FILE");
  refuses({"--trajectory", csv_, "--trajectory-period", "1e-4", "--velocity-limits", "speed=0.001"},
          "give a longer --trajectory-period");
}

TEST_F(TrajectoryCommand, TheFollowerTracksItAndArrivesInTime) {
  const Outcome outcome = follow({"--smooth", "--controller", "trajectory", "--trajectory", json_,
                                  "--speed", "1", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json trajectory = json::parse(bytes_of(json_)).at("trajectory");
  const double duration = trajectory.at("duration_s");
  EXPECT_EQ(trajectory.at("limits").at("speed"), 1) << "the robot's";
  const json drive = json::parse(outcome.out).at("drives").at(0);
  EXPECT_EQ(drive.at("controller"), "trajectory");
  EXPECT_NEAR(drive.at("time_s"), duration, 0.05 * duration);
}

TEST_F(TrajectoryCommand, TheTrackerHasOptionsAndSaysWhatItCannotTrack) {
  EXPECT_EQ(follow({"--compare=trajectory:along_gain=1,trajectory:lateral_acceleration=0.5"}).code,
            0);
  EXPECT_THAT(follow({"--controller", "trajectory", "--lookahead", "1"}).err,
              HasSubstr("the controller 'trajectory' has no option --lookahead"));
  EXPECT_THAT(
      follow({"--controller", "trajectory", "--drivetrain", "bicycle", "--corner-rounding", "0"})
          .err,
      HasSubstr("the bicycle needs"));
  const std::string lap = folder_.write("lap.csv", "x_m,y_m\n0.5,0.5\n1.5,0.5\n1.5,1.5\n");
  EXPECT_THAT(wend({"follow", map_, "--path", lap, "--loop", "--controller", "trajectory"}).err,
              HasSubstr("--loop does not support the controller trajectory"));
}

}  // namespace
}  // namespace wend::test
