#include "wend/report/drive_report.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr Frame kFrame{.resolution = 0.5, .origin = {-1, 2, 0}, .y_up = true, .metric = true};

ControlledDrive made_up(std::string controller, DriveOutcome outcome, double time) {
  Drive drive;
  drive.outcome = outcome;
  drive.time = time;
  drive.distance = 2 * time;
  drive.turned = kPi;
  drive.cross_track_rms = 0.0125;
  drive.cross_track_largest = 0.5;
  drive.final_error = 0.0625;
  drive.samples = {{0, {1, 1, 0}, {0, 0}, 0, 0},
                   {time, {3, 1, kPi / 2}, {0.5, -1}, kPi / 2, -0.25}};
  return {std::move(controller), std::move(drive)};
}

std::vector<ControlledDrive> several() {
  return {made_up("p", DriveOutcome::reached, 12), made_up("pid", DriveOutcome::stuck, 3),
          made_up("pure_pursuit", DriveOutcome::reached, 10)};
}

RefinedPath some_path() {
  RefinedPath path;
  path.before = Path({{0, 0}, {1, 0}});
  path.refined.path = path.before;
  return path;
}

TEST(DriveTable, OfOneDriveHasALineForEachThing) {
  EXPECT_EQ(drive_table(std::vector{made_up("pid", DriveOutcome::reached, 10)}),
            "controller           pid\n"
            "outcome              reached the goal\n"
            "time                 10.00 s\n"
            "distance             20.00 m\n"
            "turned               180 degrees\n"
            "rms cross-track      0.013 m\n"
            "largest cross-track  0.500 m\n"
            "final error          0.062 m\n"
            "final heading error  0.0 degrees\n"
            "collisions           0\n");
}

TEST(DriveTable, MarksTheBestOfThoseThatReachedTheGoal) {
  const std::string table = drive_table(several());
  EXPECT_THAT(table, HasSubstr("p             reached  12.00    24.00 "));
  EXPECT_THAT(table, HasSubstr("pid           stuck     3.00     6.00 "));
  EXPECT_THAT(table, HasSubstr("pure_pursuit  reached  10.00*   20.00*"));
  EXPECT_THAT(table, HasSubstr("* best of those that reached the goal\n"));
}

TEST(DriveTable, FitsIntoEightyColumns) {
  std::vector<ControlledDrive> drives = several();
  drives[1].controller = "pid:rate_gain=15";
  ASSERT_EQ(drives[1].controller.size(), 16U);
  drives[1].drive.outcome = DriveOutcome::collision;
  for (ControlledDrive& driven : drives) {
    driven.drive.collisions = 12;
    driven.drive.turned *= 30;
    driven.drive.time *= 60;
    driven.drive.distance *= 60;
  }
  std::istringstream lines(drive_table(drives));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(DriveJson, HasEachDriveAndItsSamplesInTheMapsFrame) {
  std::vector<ControlledDrive> drives = several();
  drives[1].drive.collisions = 1;
  drives[1].drive.first_collision = Point{3, 1};
  const json all = json::parse(drive_json(some_path(), drives, kFrame, DriveSamples::all));
  EXPECT_EQ(all.at("path"), json::parse("[[0,0],[1,0]]"));
  EXPECT_EQ(all.at("schema"), 1);
  const json& first = all.at("drives").at(0);
  EXPECT_EQ(first.at("controller"), "p");
  EXPECT_EQ(first.at("outcome"), "reached");
  EXPECT_EQ(first.at("time_s"), 12);
  EXPECT_NEAR(first.at("turned_degrees").get<double>(), 180, 1e-9);
  EXPECT_TRUE(first.at("first_collision").is_null());
  const json& samples = first.at("samples");
  EXPECT_EQ(samples.at("time_s"), json({0.0, 12.0}));
  EXPECT_EQ(samples.at("x_m"), json({-0.5, 0.5}));
  EXPECT_EQ(samples.at("y_m"), json({2.5, 2.5}));
  EXPECT_EQ(samples.at("yaw"), json({0.0, kPi / 2}));
  EXPECT_EQ(samples.at("angular_rad_s"), json({0.0, -1.0}));
  EXPECT_EQ(samples.at("heading_error_degrees"), json({0.0, 90.0}));
  EXPECT_EQ(samples.at("cross_track_m"), json({0.0, -0.25}));
  EXPECT_EQ(all.at("drives").at(1).at("first_collision"), json::parse("[3,1]"));
  EXPECT_EQ(all.at("drives").at(1).at("first_collision_m"), json::parse("[0.5,2.5]"));
  const json none = json::parse(drive_json(some_path(), drives, kFrame, DriveSamples::none));
  EXPECT_FALSE(none.at("drives").at(0).contains("samples"));
}

TEST(DriveCsv, HasALineForEachSample) {
  EXPECT_EQ(drive_csv(std::vector{made_up("p", DriveOutcome::reached, 12)}, kFrame),
            "controller,time_s,x_m,y_m,yaw,linear_m_s,angular_rad_s,heading_error_rad,"
            "cross_track_m\n"
            "p,0,-0.5,2.5,0,0,0,0,0\n"
            "p,12,0.5,2.5,1.5707963267948966,0.5,-1,1.5707963267948966,-0.25\n");
  EXPECT_THAT(drive_csv(std::vector{made_up("p:a=1,b=2", DriveOutcome::reached, 1)}, kFrame),
              HasSubstr("\n\"p:a=1,b=2\",1,"));
}

}  // namespace
}  // namespace wend
