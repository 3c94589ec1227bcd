// planner_server and map_server, called as other nodes call them.

#include <actionlib/client/simple_action_client.h>
#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/LoadMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>
#include <wend_ros/PlanPath.h>
#include <wend_ros/PlanPathAction.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "next_message.hpp"
#include "planner_client.hpp"
#include "wend/path/path_metrics.hpp"

namespace wend_ros {
namespace {

class PlannerServer : public testing::Test {
 protected:
  void SetUp() override {
    client_ = node_.serviceClient<PlanPath>("plan_path");
    ASSERT_TRUE(client_.waitForExistence(kPatience));
    // The map comes by a topic, after the services are there.
    const ros::Time end = ros::Time::now() + kPatience;
    while (ros::Time::now() < end && plan(request(1.5, 1.5)).status == 250) {
      ros::Duration(0.05).sleep();
    }
  }

  PlanResult plan(const PlanRequest& request) {
    PlanPath call;
    call.request.request = request;
    EXPECT_TRUE(client_.call(call));
    return call.response.result;
  }

  void set_number(const std::string& name, double value) {
    dynamic_reconfigure::Reconfigure call;
    dynamic_reconfigure::DoubleParameter parameter;
    parameter.name = name;
    parameter.value = value;
    call.request.config.doubles = {parameter};
    EXPECT_TRUE(ros::service::call("planner_server/set_parameters", call));
  }

  void set_text(const std::string& name, const std::string& value) {
    dynamic_reconfigure::Reconfigure call;
    dynamic_reconfigure::StrParameter parameter;
    parameter.name = name;
    parameter.value = value;
    call.request.config.strs = {parameter};
    EXPECT_TRUE(ros::service::call("planner_server/set_parameters", call));
  }

  ros::NodeHandle node_;
  ros::ServiceClient client_;
};

TEST_F(PlannerServer, AnswersItsOwnService) {
  const PlanResult result = plan(request(38.5, 1.5));
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_EQ(result.status_name, "found");
  EXPECT_EQ(result.path.poses.front().pose.position.x, 1.5);
  EXPECT_EQ(result.path.poses.back().pose.position.x, 38.5);
  EXPECT_GT(result.metrics.expanded, 0U);
  EXPECT_NEAR(result.cost, result.path_metrics.length, 1e-9) << "a cell is a metre here";
  EXPECT_LE(result.smoothed.poses.size(), result.path.poses.size());
}

TEST_F(PlannerServer, AnswersEveryMetricOfTheLibrary) {
  const PlanResult result = plan(request(38.5, 1.5));
  const std::vector<wend::Metric> listed = metrics_of(wend::PathMetrics{});
  ASSERT_EQ(result.path_metrics.all.size(), listed.size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    EXPECT_EQ(result.path_metrics.all[i].name, listed[i].name);
  }
  EXPECT_EQ(result.path_metrics.all.front().value, result.path_metrics.length);
}

TEST_F(PlannerServer, AnswersGetPlan) {
  ros::ServiceClient client = node_.serviceClient<nav_msgs::GetPlan>("make_plan");
  nav_msgs::GetPlan call;
  call.request.start = pose(1.5, 1.5);
  call.request.goal = pose(10.5, 1.5);
  ASSERT_TRUE(client.call(call));
  EXPECT_EQ(call.response.plan.poses.size(), 10U);
  EXPECT_EQ(call.response.plan.header.frame_id, "map");
}

TEST_F(PlannerServer, GivesEveryReasonItsNumber) {
  EXPECT_EQ(plan(request(50, 1.5)).status, 204);
  EXPECT_EQ(plan(request(20.5, 1.5)).status, 206);
  PlanRequest outside = request(3, 3);
  outside.start = pose(-1, 0);
  EXPECT_EQ(plan(outside).status, 203);
  outside.start = pose(20.5, 5.5);
  EXPECT_EQ(plan(outside).status, 205);
  PlanRequest nowhere = request(3, 3);
  nowhere.goals.clear();
  EXPECT_EQ(plan(nowhere).status, 257);
  PlanRequest unknown = request(3, 3);
  unknown.planner = "nonsense";
  EXPECT_EQ(plan(unknown).status, 201);
}

TEST_F(PlannerServer, RefusesNumbersThatAreNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plan(request(none, 1)).status, 202);
  EXPECT_EQ(plan(request(1, std::numeric_limits<double>::infinity())).status, 202);
  EXPECT_NE(plan(request(1e300, 1)).status, 0);
}

TEST_F(PlannerServer, RefusesOrientationsThatAreNone) {
  const auto turned = [](double x, double z, double w) {
    geometry_msgs::PoseStamped made = pose(3.5, 1.5);
    made.pose.orientation.x = x;
    made.pose.orientation.z = z;
    made.pose.orientation.w = w;
    return made;
  };
  for (const auto& wrong :
       {turned(0, 0, 0), turned(0, 1e-300, 0), turned(1, 0, 0), turned(0, 0, 0.5)}) {
    for (const bool is_goal : {false, true}) {
      PlanRequest asked = request(9.5, 1.5);
      (is_goal ? asked.goals[0] : asked.start) = wrong;
      const PlanResult result = plan(asked);
      EXPECT_EQ(result.status, 202);
      const std::string begin = is_goal ? "goal: the pose has the" : "start: the pose has the";
      EXPECT_EQ(result.reason.substr(0, begin.size()), begin) << result.reason;
    }
  }
  PlanRequest nearly = request(9.5, 1.5);
  nearly.goals = {turned(0, 0, 1.0005)};
  EXPECT_EQ(plan(nearly).status, 0);
}

TEST_F(PlannerServer, RefusesMoreGoalsThanItCanAnswerSoon) {
  PlanRequest many = request(9.5, 1.5);
  many.goals.resize(100'000, many.goals[0]);
  const PlanResult result = plan(many);
  EXPECT_EQ(result.status, 257);
  EXPECT_NE(result.reason.find("at most 1000"), std::string::npos) << result.reason;
}

TEST_F(PlannerServer, RefusesUnknownFramesByName) {
  PlanRequest astray = request(3, 3);
  astray.goals = {pose(3, 3, "moon")};
  const PlanResult result = plan(astray);
  EXPECT_EQ(result.status, 202);
  EXPECT_NE(result.reason.find("moon"), std::string::npos) << result.reason;
}

TEST_F(PlannerServer, AnswersFromTheField) {
  PlanRequest asked = request(38.5, 1.5);
  const double cost = plan(asked).cost;
  asked.from_field = 1;
  EXPECT_NEAR(plan(asked).cost, cost, 1e-9);
  asked.start = pose(3.5, 7.5);
  const PlanResult second = plan(asked);
  EXPECT_TRUE(second.from_field);
  EXPECT_EQ(second.metrics.expanded, 0U);
}

TEST_F(PlannerServer, PlansForACarWithItsMoves) {
  PlanRequest asked = request(10, 1);
  asked.start = pose(2, 1);
  asked.planner = "car";
  const PlanResult result = plan(asked);
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_EQ(result.moves.size() + 1, result.path.poses.size());
  EXPECT_EQ(result.moves.front(), "FWD");
}

TEST_F(PlannerServer, PlansToGoalsFromRvizAndShowsThemToLateSubscribers) {
  auto goals = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
  auto starts = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
  while (goals.getNumSubscribers() == 0 || starts.getNumSubscribers() == 0) {
    ros::Duration(0.05).sleep();
  }
  geometry_msgs::PoseWithCovarianceStamped start;
  start.header.frame_id = "map";
  start.pose.pose = pose(5.5, 5.5).pose;
  starts.publish(start);
  goals.publish(pose(9.5, 5.5));
  const ros::Time end = ros::Time::now() + kPatience;
  std::optional<nav_msgs::Path> path;
  do {
    path = next<nav_msgs::Path>("plan");
    ASSERT_TRUE(path);
  } while (ros::Time::now() < end &&
           (path->poses.empty() || path->poses.back().pose.position.x != 9.5 ||
            path->poses.front().pose.position.x != 5.5));
  EXPECT_EQ(path->poses.size(), 5U);
  EXPECT_EQ(next<geometry_msgs::PoseArray>("plan_poses")->poses.size(), 5U);
  EXPECT_FALSE(next<nav_msgs::Path>("plan_smoothed")->poses.empty());
  const auto trajectory = next<nav_msgs::Path>("trajectory");
  ASSERT_FALSE(trajectory->poses.empty());
  EXPECT_EQ(trajectory->poses.front().header.stamp, trajectory->header.stamp);
  EXPECT_GT(trajectory->poses.back().header.stamp, trajectory->header.stamp);
  EXPECT_FALSE(next<visualization_msgs::MarkerArray>("markers")->markers.empty());
}

TEST_F(PlannerServer, ShowsTheOrderOfExpansion) {
  auto goals = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
  std::optional<nav_msgs::OccupancyGrid> seen;
  const auto watcher = node_.subscribe<nav_msgs::OccupancyGrid>(
      "expansion", 1, [&](const nav_msgs::OccupancyGridConstPtr& grid) { seen = *grid; });
  const ros::Time end = ros::Time::now() + kPatience;
  while (ros::Time::now() < end && !seen) {
    goals.publish(pose(30.5, 3.5));
    ros::Duration(0.2).sleep();
    ros::spinOnce();
  }
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->data.size(), 1600U);
  int first = 0;
  int beyond = 0;
  for (const auto value : seen->data) {
    first += value == 1 ? 1 : 0;
    beyond += value > 98 || value < 0 ? 1 : 0;
  }
  EXPECT_GE(first, 1);
  EXPECT_EQ(beyond, 0);
}

TEST_F(PlannerServer, ItsActionSucceedsAndTellsWhyNot) {
  actionlib::SimpleActionClient<PlanPathAction> action("plan_path_action", true);
  ASSERT_TRUE(action.waitForServer(kPatience));
  PlanPathGoal goal;
  goal.request = request(38.5, 1.5);
  EXPECT_EQ(action.sendGoalAndWait(goal, kPatience), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(action.getResult()->result.status, 0);
  goal.request = request(20.5, 1.5);
  EXPECT_EQ(action.sendGoalAndWait(goal, kPatience), actionlib::SimpleClientGoalState::ABORTED);
  EXPECT_EQ(action.getResult()->result.status, 206);
}

TEST_F(PlannerServer, ParametersChangeWhileItRuns) {
  set_number("lambda", 3);
  EXPECT_EQ(plan(request(38.5, 1.5)).bound, 3);
  set_number("lambda", -3);
  EXPECT_EQ(plan(request(38.5, 1.5)).bound, 3) << "what is out of range changes nothing";
  set_number("lambda", 1);
  EXPECT_EQ(plan(request(38.5, 1.5)).bound, 1);
  EXPECT_TRUE(next<dynamic_reconfigure::Config>("planner_server/parameter_updates"));
}

TEST_F(PlannerServer, RadiusOfTheRobotChangesWhileItRuns) {
  set_number("robot_radius", 3);
  EXPECT_EQ(plan(request(38.5, 1.5)).status, 205) << "the robot would leave the map";
  set_text("outside", "free");
  EXPECT_GT(plan(request(38.5, 1.5)).path_metrics.smallest_clearance, 2.99);
  set_text("outside", "blocked");
  set_number("robot_radius", 0);
}

TEST(MapServer, ServesAndReloadsItsMap) {
  ros::NodeHandle node;
  ros::ServiceClient get = node.serviceClient<nav_msgs::GetMap>("static_map");
  ASSERT_TRUE(get.waitForExistence(kPatience));
  nav_msgs::GetMap map;
  ASSERT_TRUE(get.call(map));
  EXPECT_EQ(map.response.map.info.width, 40U);
  EXPECT_EQ(map.response.map.data[20], 100) << "the wall is at the bottom, as drawn";
  const auto latched = next<nav_msgs::OccupancyGrid>("map");
  ASSERT_TRUE(latched);
  EXPECT_EQ(latched->data, map.response.map.data);
  ros::ServiceClient reload = node.serviceClient<std_srvs::Trigger>("map_server/reload");
  std_srvs::Trigger again;
  ASSERT_TRUE(reload.call(again));
  EXPECT_TRUE(again.response.success) << again.response.message;
}

TEST(MapServer, KeepsItsMapWhereAnotherOneIsNone) {
  ros::NodeHandle node;
  ros::ServiceClient change = node.serviceClient<nav_msgs::LoadMap>("change_map");
  ASSERT_TRUE(change.waitForExistence(kPatience));
  nav_msgs::LoadMap other;
  other.request.map_url = "/nowhere/map.yaml";
  ASSERT_TRUE(change.call(other));
  EXPECT_NE(other.response.result, nav_msgs::LoadMap::Response::RESULT_SUCCESS);
  EXPECT_EQ(next<nav_msgs::OccupancyGrid>("map")->info.width, 40U);
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "planner_server_rostest");
  ros::NodeHandle node;  // keeps ROS up between the tests
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
