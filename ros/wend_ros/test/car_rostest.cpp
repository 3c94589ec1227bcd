// car.launch with its ten arguments, and the car's service and action.

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseArray.h>
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/MarkerArray.h>
#include <wend_ros/PlanCar.h>
#include <wend_ros/PlanCarAction.h>

#include "next_message.hpp"

namespace wend_ros {
namespace {

CarRequest empty_yard() {
  CarRequest request;
  request.mapWidth = request.mapHeight = 20;
  request.start.d = 2;
  request.goal.x = request.goal.y = 18;
  request.goal.d = 2;
  return request;
}

TEST(CarLaunch, ShowsTheYardInColoursAndTheDriveAsPoses) {
  const auto markers = next<visualization_msgs::MarkerArray>("car_markers");
  ASSERT_TRUE(markers);
  ASSERT_EQ(markers->markers.size(), 2U);
  EXPECT_EQ(markers->markers[0].points.size(), 25U);
  EXPECT_GT(markers->markers[0].color.r, 2 * markers->markers[0].color.g) << "obstacles are red";
  EXPECT_EQ(markers->markers[1].points.size(), 25U);
  EXPECT_GT(markers->markers[1].color.g, 0.5) << "rough roads are yellow";
  const auto poses = next<geometry_msgs::PoseArray>("car_poses");
  ASSERT_TRUE(poses);
  EXPECT_EQ(poses->header.frame_id, "car_map");
  ASSERT_GE(poses->poses.size(), 19U);
  EXPECT_EQ(poses->poses.front().position.x, 0);
  EXPECT_EQ(poses->poses.back().position.y, 18);
}

TEST(CarLaunch, TurnsTheMapOverSoThatYPointsSouth) {
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  const auto transform = buffer.lookupTransform("map", "car_map", ros::Time(0), kPatience);
  EXPECT_NEAR(transform.transform.rotation.x, 1, 1e-12);
  EXPECT_NEAR(transform.transform.rotation.w, 0, 1e-12);
}

TEST(CarServer, AnswersItsService) {
  ros::NodeHandle node;
  ros::ServiceClient client = node.serviceClient<PlanCar>("plan_car");
  ASSERT_TRUE(client.waitForExistence(kPatience));
  PlanCar call;
  call.request.request = empty_yard();
  ASSERT_TRUE(client.call(call));
  EXPECT_EQ(call.response.result.status, 0);
  EXPECT_EQ(call.response.result.moves.size(), 18U);
  EXPECT_NEAR(call.response.result.fuel, 28.2743, 1e-4);
  call.request.request.goal.x = 40;
  ASSERT_TRUE(client.call(call));
  EXPECT_EQ(call.response.result.status, 204);
  EXPECT_TRUE(call.response.result.path.empty());
}

TEST(CarServer, AnswersItsAction) {
  actionlib::SimpleActionClient<PlanCarAction> action("plan_car_action", true);
  ASSERT_TRUE(action.waitForServer(kPatience));
  PlanCarGoal goal;
  goal.request = empty_yard();
  EXPECT_EQ(action.sendGoalAndWait(goal, kPatience), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(action.getResult()->result.moves.front(), CarResult::FWD_RIGHT);
  goal.request.goal.d = 7;
  EXPECT_EQ(action.sendGoalAndWait(goal, kPatience), actionlib::SimpleClientGoalState::ABORTED);
  EXPECT_EQ(action.getResult()->result.status, 257);
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "car_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
