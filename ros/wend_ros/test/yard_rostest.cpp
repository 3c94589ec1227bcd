// car.launch with a yard from a file, and what the client says by its exit code.

#include <geometry_msgs/PoseArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sys/wait.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdlib>
#include <string>

#include "next_message.hpp"

namespace wend_ros {
namespace {

/// The exit code of the client with these arguments.
int exit_code(const std::string& arguments) {
  const std::string command =
      "rosrun wend_ros car_planner_client " + arguments + " __name:=another_client";
  return WEXITSTATUS(std::system(command.c_str()));
}

TEST(YardLaunch, ShowsTheYardOfTheFile) {
  const auto markers = next<visualization_msgs::MarkerArray>("car_markers");
  ASSERT_TRUE(markers);
  EXPECT_EQ(markers->markers.front().points.size(), 4U);
  const auto poses = next<geometry_msgs::PoseArray>("car_poses");
  ASSERT_TRUE(poses);
  ASSERT_FALSE(poses->poses.empty());
  EXPECT_EQ(poses->poses.back().position.x, 7);
  EXPECT_EQ(poses->poses.back().position.y, 5);
}

TEST(CarClient, SaysHowItEndedByItsExitCode) {
  EXPECT_EQ(exit_code("20 20 0 0 2 18 18 2 25 25"), 0);
  EXPECT_EQ(exit_code("20 20 0 0 2 18 40 2 0 0"), 1) << "the goal is outside";
  EXPECT_EQ(exit_code("20 20"), 2);
  EXPECT_EQ(exit_code("20 20 0 0 2 18 18 2 25 x"), 2);
  EXPECT_EQ(exit_code("yard:=/nowhere/yard.txt"), 2);
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "yard_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
