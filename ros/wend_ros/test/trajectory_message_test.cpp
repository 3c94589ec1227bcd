// Trajectories as messages, to and from, and which of them the follower tracks.

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend_ros/path_message.hpp"
#include "wend_ros/tracking.hpp"

namespace wend_ros {
namespace {

constexpr wend::Frame kTenth{.resolution = 0.1, .origin = {3, -2, 0.3}};

wend::Trajectory along(const wend::Path& path) {
  return *wend::Trajectory::along(path, kTenth, {.speed = 1});
}

std::vector<wend::Path> paths() {
  return {wend::Path::along({{0, 0}, {50, 0}, {50, 30}, {0, 31}}),
          wend::Path::through({{0, 0, 0}, {20, 20, wend::kPi / 2}, {20, 20, 3}, {40, 20, 3}}),
          wend::Path::through({{7, 7, 1}})};
}

nav_msgs::Path message_of(const wend::Trajectory& trajectory) {
  const ros::Time now(1'800'000'000, 123'456'789);
  return starting_at(now, to_message(trajectory, "map", 0.1));
}

std::string fault_of(const nav_msgs::Path& message) {
  const auto trajectory = trajectory_from(message);
  return trajectory ? std::string() : trajectory.error().message;
}

TEST(TrajectoryMessage, OfAPlannerComesBackAsItWas) {
  for (const wend::Path& path : paths()) {
    const wend::Trajectory sent = along(path);
    const auto got = trajectory_from(message_of(sent));
    ASSERT_TRUE(got) << got.error().message;
    EXPECT_NEAR(got->duration(), sent.duration(), 1e-8);
    EXPECT_NEAR(got->length(), sent.length(), 0.02 * sent.length());
    for (double time = 0; time < sent.duration(); time += 0.03) {
      const wend::MapPose a = sent.at(time).pose;
      const wend::MapPose b = got->at(time).pose;
      ASSERT_LT(distance(a.point(), b.point()), 0.01) << time;
      ASSERT_LT(std::abs(wend::normalized_angle(a.heading - b.heading)), 0.03) << time;
      ASSERT_NEAR(got->at(time).speed, sent.at(time).speed, 0.11) << time;
    }
    const wend::MapPose end = got->at(got->duration()).pose;
    EXPECT_LT(distance(end.point(), sent.at(sent.duration()).pose.point()), 1e-9);
  }
}

TEST(TrajectoryMessage, StartsWithItsFirstStampWhateverThatIs) {
  nav_msgs::Path message = message_of(along(paths()[0]));
  const double duration = trajectory_from(message)->duration();
  for (auto& stamped : message.poses) stamped.header.stamp.sec -= 1'800'000'000;
  EXPECT_EQ(trajectory_from(message)->duration(), duration);
  message.poses.back().header.stamp.sec = 4'294'967'295;
  EXPECT_GT(trajectory_from(message)->duration(), 4e9) << "ros::Duration would throw";
}

TEST(TrajectoryMessage, IsRefusedWhereItIsNoTrajectory) {
  const nav_msgs::Path right = message_of(along(paths()[0]));
  EXPECT_EQ(fault_of(right), "");
  EXPECT_EQ(fault_of({}), "the trajectory has no poses");
  nav_msgs::Path wrong = right;
  wrong.poses[2].header.stamp = wrong.poses[1].header.stamp;
  EXPECT_EQ(fault_of(wrong), "pose 2 of the trajectory is not later than the pose before it");
  wrong = right;
  wrong.poses[4].pose.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of(wrong), "pose 4 of the trajectory contains NaN or infinity");
  wrong = right;
  wrong.poses[4].pose.orientation.w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of(wrong), "pose 4 of the trajectory contains NaN or infinity");
  wrong = right;
  wrong.poses[4].pose.orientation = {};
  EXPECT_EQ(fault_of(wrong),
            "pose 4 of the trajectory has the orientation (0, 0, 0, 0), whose length is 0, not 1");
  wrong = right;
  wrong.poses[3].header.frame_id = "moon";
  EXPECT_EQ(fault_of(wrong), "a pose of the trajectory is in the frame 'moon', not 'map'");
  for (auto& stamped : wrong.poses) stamped.header.stamp = ros::Time();
  wrong.poses[3].header.frame_id = "map";
  EXPECT_NE(fault_of(wrong), "") << "a path without times";
}

TEST(Trackable, IsWhatThePlannersSendWithinTheLimits) {
  for (const wend::Path& path : paths()) {
    const auto got = trajectory_from(message_of(along(path)));
    EXPECT_EQ(why_untrackable(*got, {.speed = 1}), "");
  }
}

TEST(Trackable, IsNotWhatStepsAsideOrIsFasterThanTheRobot) {
  const auto aside =
      trajectory_from(message_of(along(wend::Path::through({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}}))));
  EXPECT_NE(why_untrackable(*aside, {.speed = 1}).find("it moves to the side at ("),
            std::string::npos);
  const auto fast = trajectory_from(message_of(along(paths()[0])));
  EXPECT_EQ(why_untrackable(*fast, {.speed = 0.5}), "it needs 1 m/s, and ~speed is 0.5");
  EXPECT_NE(why_untrackable(*fast, {.speed = 1, .turn_rate = 0.5}).find("~turn_rate"),
            std::string::npos);
}

}  // namespace
}  // namespace wend_ros
