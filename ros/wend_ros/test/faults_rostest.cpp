// What goes wrong on a robot: no map, maps that are none, huge ones, cancelled goals, a killed node.
// The test itself publishes the maps.

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <signal.h>
#include <wend_ros/PlanPath.h>
#include <wend_ros/PlanPathAction.h>

#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <thread>

#include "next_message.hpp"
#include "planner_client.hpp"
#include "process_of_node.hpp"

namespace wend_ros {
namespace {

nav_msgs::OccupancyGrid free_map(std::uint32_t side, float resolution = 1) {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.width = grid.info.height = side;
  grid.info.resolution = resolution;
  grid.info.origin.orientation.w = 1;
  grid.data.assign(std::size_t{side} * side, 0);
  return grid;
}

class Faults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    maps_ =
        new ros::Publisher(ros::NodeHandle().advertise<nav_msgs::OccupancyGrid>("map", 1, true));
  }
  static void TearDownTestSuite() { delete maps_; }

  void SetUp() override {
    client_ = node_.serviceClient<PlanPath>("plan_path");
    ASSERT_TRUE(client_.waitForExistence(kPatience));
    ASSERT_TRUE(wait_until([] { return maps_->getNumSubscribers() > 0; }));
  }

  /// The status, or -1 without an answer.
  int status_of(const PlanRequest& request) {
    PlanPath call;
    call.request.request = request;
    return client_.call(call) ? call.response.result.status : -1;
  }

  /// Publishes a map and waits until the planner has it, which a goal shows.
  void put_map(const nav_msgs::OccupancyGrid& map, const PlanRequest& shows, int status) {
    maps_->publish(map);
    ASSERT_TRUE(wait_until([&] { return status_of(shows) == status; }));
  }

  /// Begins a search that takes long, and waits until it runs. The feedback that showed it.
  static PlanPathFeedback begin_long_search(actionlib::SimpleActionClient<PlanPathAction>& action,
                                            const PlanRequest& request) {
    EXPECT_TRUE(action.waitForServer(kPatience));
    PlanPathGoal goal;
    goal.request = request;
    goal.request.planner = "dijkstra";
    // Feedback may come after this has returned.
    struct Newest {
      std::mutex mutex;
      PlanPathFeedback feedback;
    };
    const auto newest = std::make_shared<Newest>();
    action.sendGoal(goal, {}, {}, [newest](const PlanPathFeedbackConstPtr& feedback) {
      const std::lock_guard lock(newest->mutex);
      newest->feedback = *feedback;
    });
    const auto feedback = [newest] {
      const std::lock_guard lock(newest->mutex);
      return newest->feedback;
    };
    EXPECT_TRUE(wait_until([&] { return feedback().expanded > 1000; }));
    return feedback();
  }

  static ros::Publisher* maps_;
  ros::NodeHandle node_;
  ros::ServiceClient client_;
};

ros::Publisher* Faults::maps_ = nullptr;

TEST_F(Faults, WithoutAMapEveryQueryIsAnswered) { EXPECT_EQ(status_of(request(3.5, 3.5)), 250); }

TEST_F(Faults, MapsThatAreNoneAreToldAndNotUsed) {
  put_map(free_map(20), request(3.5, 3.5), 0);
  put_map(free_map(0), request(3.5, 3.5), 250);
  put_map(free_map(20), request(3.5, 3.5), 0);
  put_map(free_map(20, 0), request(3.5, 3.5), 250);
  put_map(free_map(20), request(3.5, 3.5), 0);
  put_map(free_map(20, std::numeric_limits<float>::quiet_NaN()), request(3.5, 3.5), 250);
  nav_msgs::OccupancyGrid cut = free_map(20);
  put_map(cut, request(3.5, 3.5), 0);
  cut.data.pop_back();
  put_map(cut, request(3.5, 3.5), 250);
}

TEST_F(Faults, ANewMapCounts) {
  put_map(free_map(20), request(3.5, 3.5), 0);
  EXPECT_EQ(status_of(request(30.5, 3.5)), 204);
  put_map(free_map(40), request(30.5, 3.5), 0);
}

/// roscpp loses a call now and then when two threads make some: that is repeated. What the node answers
/// counts.
bool call_again_if_lost(ros::ServiceClient& client, PlanPath& call) {
  constexpr int kMostLost = 3;
  for (int lost = 0; lost < kMostLost; ++lost) {
    if (client.call(call)) return true;
    std::cout << "a call was lost\n";
  }
  return false;
}

TEST_F(Faults, TwoClientsAtOnceAreBothAnswered) {
  put_map(free_map(400), request(399.5, 399.5), 0);
  const auto ask_often = [](int& found) {
    ros::NodeHandle node;
    ros::ServiceClient client = node.serviceClient<PlanPath>("plan_path");
    for (int i = 0; i < 30; ++i) {
      PlanPath call;
      call.request.request = request(399.5, 10 * i + 1.5);
      const bool answered = call_again_if_lost(client, call);
      if (answered && call.response.result.status == 0) ++found;
      if (answered && call.response.result.status != 0)
        std::cout << call.response.result.reason << "\n";
    }
  };
  int first = 0;
  int second = 0;
  std::thread other([&] { ask_often(first); });
  ask_often(second);
  other.join();
  EXPECT_EQ(first, 30);
  EXPECT_EQ(second, 30);
}

TEST_F(Faults, ACancelledSearchEndsAtOnceOnAHugeMap) {
  put_map(free_map(4096), request(4095.5, 4095.5), 0);
  actionlib::SimpleActionClient<PlanPathAction> action("plan_path_action", true);
  const PlanPathFeedback seen = begin_long_search(action, request(4095.5, 4095.5));
  EXPECT_GT(seen.best_bound, 0);
  const ros::WallTime asked = ros::WallTime::now();
  action.cancelGoal();
  ASSERT_TRUE(action.waitForResult(kPatience));
  const double seconds = (ros::WallTime::now() - asked).toSec();
  std::cout << "cancelled after " << seen.expanded << " expansions, answered in " << 1e3 * seconds
            << " ms\n";
  EXPECT_EQ(action.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_EQ(action.getResult()->result.status, 251);
  EXPECT_LT(action.getResult()->result.metrics.expanded, 4096U * 4096U) << "it did not run on";
}

TEST_F(Faults, ANewGoalPreemptsTheOneBefore) {
  put_map(free_map(4096), request(4095.5, 4095.5), 0);
  actionlib::SimpleActionClient<PlanPathAction> first("plan_path_action", true);
  actionlib::SimpleActionClient<PlanPathAction> second("plan_path_action", true);
  ASSERT_TRUE(second.waitForServer(kPatience));
  begin_long_search(first, request(4095.5, 4095.5));
  PlanPathGoal goal;
  goal.request = request(10.5, 10.5);
  EXPECT_EQ(second.sendGoalAndWait(goal, kPatience), actionlib::SimpleClientGoalState::SUCCEEDED);
  ASSERT_TRUE(first.waitForResult(kPatience));
  EXPECT_EQ(first.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
}

TEST_F(Faults, AMapThatChangesWhileASearchRunsDoesNotDisturbIt) {
  put_map(free_map(4096), request(4095.5, 4095.5), 0);
  actionlib::SimpleActionClient<PlanPathAction> action("plan_path_action", true);
  begin_long_search(action, request(1500.5, 1500.5));
  maps_->publish(free_map(20));
  ASSERT_TRUE(action.waitForResult(kPatience));
  EXPECT_EQ(action.getResult()->result.status, 0) << "it is the plan on the map that it began with";
  EXPECT_EQ(action.getResult()->result.path.poses.size(), 1500U);
  EXPECT_TRUE(wait_until([&] { return status_of(request(1500.5, 1500.5)) == 204; }));
}

/// How many threads a process has.
long threads_of(int pid) {
  const std::filesystem::path tasks = "/proc/" + std::to_string(pid) + "/task";
  return std::distance(std::filesystem::directory_iterator(tasks), {});
}

TEST_F(Faults, ManyGoalsLeaveNoThreadsBehind) {
  put_map(free_map(40), request(30.5, 3.5), 0);
  actionlib::SimpleActionClient<PlanPathAction> action("plan_path_action", true);
  ASSERT_TRUE(action.waitForServer(kPatience));
  const int pid = pid_of("/planner_server");
  ASSERT_GT(pid, 0);
  PlanPathGoal goal;
  goal.request = request(30.5, 3.5);
  action.sendGoalAndWait(goal, kPatience);
  const long before = threads_of(pid);
  for (int i = 0; i < 30; ++i) action.sendGoalAndWait(goal, kPatience);
  EXPECT_LE(threads_of(pid), before + 2) << "connections come and go, a thread a goal must not";
}

TEST_F(Faults, AKilledNodeComesBackAndAnswers) {
  put_map(free_map(20), request(3.5, 3.5), 0);
  const int pid = pid_of("/planner_server");
  ASSERT_GT(pid, 0);
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  ASSERT_TRUE(wait_until([&] {
    const int now = pid_of("/planner_server");
    return now > 0 && now != pid;
  }));
  // The map is latched: the new process gets it.
  EXPECT_TRUE(wait_until([&] { return status_of(request(3.5, 3.5)) == 0; }));
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "faults_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
