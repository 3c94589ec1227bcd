// explore.launch: a robot that drives to its goal through land that it does not know.

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <sys/wait.h>
#include <wend_ros/PlanResult.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "next_message.hpp"
#include "planner_client.hpp"

namespace wend_ros {
namespace {

/// All that the nodes say. The map is put together as every client does it.
class Explorer {
 public:
  Explorer() {
    listen<nav_msgs::OccupancyGrid>("map", [this](const auto& map) { known_ = map; });
    listen<map_msgs::OccupancyGridUpdate>("map_updates", [this](const auto& one) { put(one); });
    listen<nav_msgs::Odometry>(
        "odom", [this](const auto& odometry) { way_.push_back(odometry.pose.pose.position); });
    listen<PlanResult>("plan_result", [this](const auto& result) { plans_.push_back(result); });
    listen<std_msgs::String>("follower/state", [this](const auto& state) { state_ = state.data; });
  }

  nav_msgs::OccupancyGrid known() const { return locked(known_); }
  std::vector<geometry_msgs::Point> way() const { return locked(way_); }
  std::vector<PlanResult> plans() const { return locked(plans_); }
  std::string state() const { return locked(state_); }

  std::size_t unknown_cells() const {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count(known_.data.begin(), known_.data.end(), -1));
  }

 private:
  template <class Value>
  Value locked(const Value& value) const {
    const std::lock_guard lock(mutex_);
    return value;
  }

  template <class Message, class Take>
  void listen(const std::string& topic, Take take) {
    constexpr std::uint32_t kMost = 1000;
    subscribers_.push_back(node_.subscribe<Message>(
        topic, kMost, [this, take](const boost::shared_ptr<const Message>& message) {
          const std::lock_guard lock(mutex_);
          take(*message);
        }));
  }

  void put(const map_msgs::OccupancyGridUpdate& update) {
    if (known_.data.empty()) return;
    for (std::uint32_t i = 0; i < update.data.size(); ++i) {
      const auto x = static_cast<std::uint32_t>(update.x) + i % update.width;
      const auto y = static_cast<std::uint32_t>(update.y) + i / update.width;
      known_.data[std::size_t{y} * known_.info.width + x] = update.data[i];
    }
  }

  ros::NodeHandle node_;
  mutable std::mutex mutex_;
  nav_msgs::OccupancyGrid known_;
  std::vector<geometry_msgs::Point> way_;
  std::vector<PlanResult> plans_;
  std::string state_;
  std::vector<ros::Subscriber> subscribers_;
};

std::int8_t value_at(const nav_msgs::OccupancyGrid& map, double x, double y) {
  const auto column = static_cast<std::size_t>(x / map.info.resolution);
  const auto row = static_cast<std::size_t>(y / map.info.resolution);
  return map.data.at(row * map.info.width + column);
}

TEST(Exploring, ReachesAGoalBehindAWallThatItDidNotKnow) {
  const Explorer explorer;
  const auto truth = next<nav_msgs::OccupancyGrid>("true_map");
  ASSERT_TRUE(truth);
  ASSERT_TRUE(wait_until([&] { return !explorer.known().data.empty(); }));
  const std::size_t unknown_at_first = explorer.unknown_cells();
  EXPECT_GT(unknown_at_first, truth->data.size() / 2);

  ros::NodeHandle node;
  auto goals = node.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
  ASSERT_TRUE(wait_until([&] { return goals.getNumSubscribers() > 0; }));
  const auto distance_to = [&](double x, double y) {
    const auto way = explorer.way();
    return way.empty() ? 1e9 : std::hypot(way.back().x - x, way.back().y - y);
  };
  ASSERT_TRUE(wait_until([&] { return distance_to(17.5, 26.5) < 0.5; }))
      << "the first goal came before the robot's pose";
  const auto distance_left = [&] { return distance_to(26.5, 29.5); };
  goals.publish(pose(26.5, 29.5));
  ASSERT_TRUE(wait_until([&] { return explorer.state() == "driving"; }));
  ASSERT_TRUE(wait_until([&] { return explorer.state() == "reached" && distance_left() < 0.5; }))
      << explorer.state() << ", " << distance_left() << " m left";

  for (const auto& at : explorer.way()) {
    ASSERT_NE(value_at(*truth, at.x, at.y), 100) << "in the wall at " << at.x << ',' << at.y;
  }
  const auto plans = explorer.plans();
  int detours = 0;
  for (std::size_t i = 1; i < plans.size(); ++i) {
    EXPECT_EQ(plans[i].status_name, "found") << plans[i].reason;
    detours += plans[i].cost > plans[i - 1].cost + 0.1 ? 1 : 0;
  }
  EXPECT_GE(detours, 1) << "the wall was longer than it looked";
  std::cout << plans.size() << " plans, " << detours << " detours\n";

  const nav_msgs::OccupancyGrid known = explorer.known();
  EXPECT_LT(explorer.unknown_cells(), unknown_at_first);
  EXPECT_GT(explorer.unknown_cells(), truth->data.size() / 10) << "it did not go everywhere";
  for (std::size_t i = 0; i < known.data.size(); ++i) {
    if (known.data[i] != -1) ASSERT_EQ(known.data[i], truth->data[i]) << i;
  }
}

/// What robot_sim says before it ends, and its exit code.
std::pair<std::string, int> run_robot_sim(const std::string& arguments) {
  FILE* const pipe =
      popen((std::string(ROBOT_SIM) + " __name:=broken " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {"it did not start", -1};
  std::string said;
  for (std::array<char, 256> text{}; fgets(text.data(), text.size(), pipe) != nullptr;) {
    said += text.data();
  }
  return {said, WEXITSTATUS(pclose(pipe))};
}

TEST(Exploring, MapsThatDoNotFitEndTheNodeWithTheirParameter) {
  const std::string room = std::string("_map:=") + TEST_FOLDER + "/room.txt";
  const auto [nowhere, first_code] = run_robot_sim("_map:=/nowhere/room.txt");
  EXPECT_EQ(first_code, 2);
  EXPECT_NE(nowhere.find("~map: /nowhere/room.txt"), std::string::npos) << nowhere;
  const auto [other, second_code] = run_robot_sim(room + " _known:=" + TEST_FOLDER + "/yard.txt");
  EXPECT_EQ(second_code, 2);
  EXPECT_NE(other.find("~known: the known map has "), std::string::npos) << other;
  EXPECT_NE(other.find("and the true one 40 x 40 cells"), std::string::npos) << other;
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "explore_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
