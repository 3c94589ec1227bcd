// parking.launch: a click parks a car with hybrid_astar, and what rviz shows of it is free.

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>
#include <wend_ros/PlanPath.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>

#include "next_message.hpp"
#include "planner_client.hpp"

namespace wend_ros {
namespace {

constexpr double kDown = -1.5707963267948966;

geometry_msgs::PoseStamped facing(double x, double y, double yaw) {
  geometry_msgs::PoseStamped stamped = pose(x, y);
  stamped.pose.orientation.z = std::sin(yaw / 2);
  stamped.pose.orientation.w = std::cos(yaw / 2);
  return stamped;
}

/// In the bay, with the rear first: the front is 10.2 m up, on the aisle's edge.
geometry_msgs::PoseStamped in_the_bay() { return facing(14.5, 14, kDown); }

class Parking : public testing::Test {
 protected:
  void SetUp() override {
    client_ = node_.serviceClient<PlanPath>("plan_path");
    ASSERT_TRUE(client_.waitForExistence(kPatience));
    ASSERT_TRUE(wait_until([&] { return park(facing(6, 4, 0)).status == 0; }));
  }

  PlanResult park(const geometry_msgs::PoseStamped& goal) {
    PlanPath call;
    call.request.request.use_start = 1;
    call.request.request.start = facing(4, 4, 0);
    call.request.request.goals = {goal};
    EXPECT_TRUE(client_.call(call));
    return call.response.result;
  }

  ros::NodeHandle node_;
  ros::ServiceClient client_;
};

bool is_free(const nav_msgs::OccupancyGrid& map, const geometry_msgs::Point& at) {
  const auto x = static_cast<int>(std::floor(at.x));
  const auto y = static_cast<int>(std::floor(at.y));
  const auto width = static_cast<int>(map.info.width);
  const auto height = static_cast<int>(map.info.height);
  if (x < 0 || y < 0 || x >= width || y >= height) return false;
  return map.data[static_cast<std::size_t>(y * width + x)] == 0;
}

/// Are all points of a line free, looked at every centimetre?
bool is_free(const nav_msgs::OccupancyGrid& map, const geometry_msgs::Point& from,
             const geometry_msgs::Point& to) {
  const int parts = 1 + static_cast<int>(100 * std::hypot(to.x - from.x, to.y - from.y));
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    geometry_msgs::Point at;
    at.x = from.x + share * (to.x - from.x);
    at.y = from.y + share * (to.y - from.y);
    if (!is_free(map, at)) return false;
  }
  return true;
}

TEST_F(Parking, AClickParksInReverseAndTheOutlinesAreFree) {
  auto goals = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
  ASSERT_TRUE(wait_until([&] { return goals.getNumSubscribers() > 0; }));
  goals.publish(in_the_bay());
  std::optional<PlanResult> result;
  ASSERT_TRUE(wait_until([&] {
    result = next<PlanResult>("plan_result");
    return result && result->status == 0;
  }));
  const auto reverse = [](const std::string& move) { return move.rfind("REV", 0) == 0; };
  EXPECT_TRUE(std::any_of(result->moves.begin(), result->moves.end(), reverse));
  const geometry_msgs::Pose& end = result->path.poses.back().pose;
  EXPECT_NEAR(end.position.x, 14.5, 1e-6);
  EXPECT_NEAR(end.position.y, 14, 1e-6);
  EXPECT_NEAR(std::abs(end.orientation.z), std::sin(-kDown / 2), 1e-6);

  const auto map = next<nav_msgs::OccupancyGrid>("map");
  ASSERT_TRUE(map);
  std::optional<visualization_msgs::Marker> outlines;
  ASSERT_TRUE(wait_until([&] {
    const auto markers = next<visualization_msgs::MarkerArray>("markers");
    for (const auto& marker : markers->markers) {
      if (marker.ns == "footprint" && !marker.points.empty()) outlines = marker;
    }
    // Between the goal's chevron and its sides: the front, 3.7 m ahead of the rear axle.
    if (!outlines) return false;
    const geometry_msgs::Point& front = outlines->points[outlines->points.size() - 2];
    return std::hypot(front.x - 14.5, front.y - 10.3) < 1e-6;
  }));
  constexpr std::size_t kPoints = 12;  // of four edges and a chevron
  EXPECT_GE(outlines->points.size(), 3 * kPoints) << "the start, a change of gear and the goal";
  for (std::size_t i = 0; i + 1 < outlines->points.size(); i += 2) {
    EXPECT_TRUE(is_free(*map, outlines->points[i], outlines->points[i + 1])) << i / kPoints;
  }
}

TEST_F(Parking, SaysWhichCornerTouches) {
  const PlanResult askew = park(facing(13.5, 14, kDown));
  EXPECT_EQ(askew.status, 206);
  EXPECT_NE(askew.reason.find("rear right corner lies in the obstacle cell (12,14)"),
            std::string::npos)
      << askew.reason;
}

TEST_F(Parking, SaysWhichParameterIsWrong) {
  PlanPath call;
  call.request.request.use_start = 1;
  call.request.request.start = facing(4, 4, 0);
  call.request.request.goals = {in_the_bay()};
  call.request.request.options = "turning_radius=0";
  ASSERT_TRUE(client_.call(call));
  EXPECT_EQ(call.response.result.status, 201);
  EXPECT_NE(call.response.result.reason.find("turning_radius greater than 0"), std::string::npos)
      << call.response.result.reason;
}

TEST_F(Parking, TellsACarThatTurnsTooWideFromOneThatParks) {
  PlanPath call;
  call.request.request.use_start = 1;
  call.request.request.start = facing(4, 4, 0);
  call.request.request.goals = {in_the_bay()};
  call.request.request.options = "turning_radius=5,allow_reverse=false";
  ASSERT_TRUE(client_.call(call));
  EXPECT_EQ(call.response.result.status, 208);
  // A car that turns in a narrower circle parks: nothing boxes the goal in.
  const std::string& reason = call.response.result.reason;
  EXPECT_NE(reason.find("was found at this resolution"), std::string::npos) << reason;
  EXPECT_EQ(reason.find("boxed in"), std::string::npos) << reason;
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "parking_rostest");
  ros::NodeHandle node;  // keeps ROS up between the tests
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
