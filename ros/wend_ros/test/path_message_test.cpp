// Paths and poses as messages: what a follower makes of them, and what it refuses.

#include "wend_ros/path_message.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"

namespace wend_ros {
namespace {

nav_msgs::Path message_of(const std::vector<wend::MapPose>& poses) {
  nav_msgs::Path message;
  message.header.frame_id = "map";
  for (const wend::MapPose& pose : poses) message.poses.emplace_back().pose = to_message(pose);
  return message;
}

std::string fault_of(const nav_msgs::Path& message) {
  const auto route = route_from(message);
  return route ? std::string() : route.error().message;
}

TEST(RouteFrom, APathOfCellsIsDrivenAheadAndEndsWithTheHeadingOfItsGoal) {
  const wend::Path cells({{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 2}});
  const wend::Frame frame{.resolution = 0.5};
  nav_msgs::Path message = to_message(cells, frame, "map");
  message = ending_with(1.25, std::move(message));
  const auto route = route_from(message);
  ASSERT_TRUE(route) << route.error().message;
  ASSERT_EQ(route->legs().size(), 1U);
  EXPECT_FALSE(route->legs()[0].reverse);
  EXPECT_NEAR(route->length(), cells.length() * frame.resolution, 1e-9);
  ASSERT_TRUE(route->final_heading());
  EXPECT_NEAR(*route->final_heading(), 1.25, 1e-9);
}

TEST(RouteFrom, AStraightLineInReverseAtHeadingZeroIsDrivenInReverse) {
  const auto route = route_from(message_of({{3, 0, 0}, {2, 0, 0}, {1, 0, 0}}));
  ASSERT_TRUE(route);
  ASSERT_EQ(route->legs().size(), 1U);
  EXPECT_TRUE(route->legs()[0].reverse);
}

TEST(RouteFrom, WithoutAnyOrientationThereAreNoHeadings) {
  nav_msgs::Path message = message_of({{3, 0, 0}, {2, 0, 0}, {1, 0, 0}});
  for (auto& stamped : message.poses) stamped.pose.orientation = {};
  const auto route = route_from(message);
  ASSERT_TRUE(route) << route.error().message;
  EXPECT_FALSE(route->legs()[0].reverse);
  EXPECT_FALSE(route->final_heading());
  message.poses[1].pose.orientation.w = 1;
  EXPECT_EQ(fault_of(message),
            "pose 0 of the path has the orientation (0, 0, 0, 0), whose length is 0, not 1");
}

TEST(RouteFrom, RefusesWhatCannotBeDriven) {
  const nav_msgs::Path right = message_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(fault_of(right), "");
  EXPECT_EQ(fault_of({}), "the path has no poses");
  for (const double number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    nav_msgs::Path wrong = right;
    wrong.poses[1].pose.position.y = number;
    EXPECT_EQ(fault_of(wrong), "pose 1 of the path contains NaN or infinity");
    wrong = right;
    wrong.poses[2].pose.orientation.z = number;
    EXPECT_EQ(fault_of(wrong), "pose 2 of the path contains NaN or infinity");
  }
  nav_msgs::Path wrong = right;
  wrong.poses[0].pose.position.x = 1e300;
  EXPECT_EQ(fault_of(wrong), "pose 0 of the path is farther than 1e8 m from the origin");
  wrong = right;
  wrong.poses[1].pose.orientation.x = 1;
  EXPECT_NE(fault_of(wrong), "");
  wrong = right;
  wrong.poses[1].header.frame_id = "odom";
  EXPECT_EQ(fault_of(wrong), "a pose of the path is in the frame 'odom', not 'map'");
}

TEST(PoseFrom, AMessageComesBackAsItWas) {
  for (const wend::MapPose& pose : {wend::MapPose{1, -2, 3}, wend::MapPose{-1e7, 5, -0.25}}) {
    const auto back = pose_from(to_message(pose));
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(back->point(), pose.point());
    EXPECT_NEAR(back->heading, pose.heading, 1e-9);
  }
}

TEST(PoseFrom, RefusesAnUnsetMessage) {
  const auto pose = pose_from(geometry_msgs::Pose{});
  ASSERT_FALSE(pose);
  EXPECT_EQ(pose.error(), "has the orientation (0, 0, 0, 0), whose length is 0, not 1");
}

TEST(EndingWith, AnEmptyPathStaysEmpty) {
  EXPECT_TRUE(ending_with(1, nav_msgs::Path()).poses.empty());
}

}  // namespace
}  // namespace wend_ros
