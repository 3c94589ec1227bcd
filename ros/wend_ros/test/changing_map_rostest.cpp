// A map of 1000 x 1000 cells that changes 20 times a second: every answer is free on the map that it names, the
// node's memory does not grow, and it needs no more than one core.

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <wend_ros/PlanPath.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "checked_answers.hpp"
#include "map_history.hpp"
#include "next_message.hpp"
#include "planner_client.hpp"
#include "process_of_node.hpp"
#include "process_usage.hpp"

namespace wend_ros {
namespace {

constexpr int kSide = 1000;
constexpr double kRate = 20;    // Hz
constexpr double kGrowth = 16;  // MB: less than a planner of this map has
constexpr double kPeak = 150;   // MB

/// Ends of queries: the centres of these cells, around which the map stays free.
constexpr std::array<int, 5> kPlaces{50, 275, 500, 725, 950};
constexpr int kFreeAround = 15;

bool is_near_a_place(int from, int to) {
  return std::any_of(kPlaces.begin(), kPlaces.end(), [&](int place) {
    return from - kFreeAround <= place && place <= to + kFreeAround;
  });
}

double metres(int cell) { return (cell + 0.5) * kResolution; }

/// Pillars all over.
ValueMap first_map() {
  ValueMap map(kSide);
  std::mt19937 random(1);
  for (int i = 0; i < 1500; ++i) {
    const int x = static_cast<int>(random() % (kSide - 8));
    const int y = static_cast<int>(random() % (kSide - 8));
    if (is_near_a_place(x, x + 8) && is_near_a_place(y, y + 8)) continue;
    apply({{}, x, y, 8, 100}, map);
  }
  return map;
}

/// Publishes a map, and then changes of it at kRate: a square that is occupied or free from then on. Every
/// 40th change comes as a whole map. Two topics have no common order: before and after a whole map it waits until the
/// node has all that was published.
class Changes {
 public:
  Changes(ros::Publisher maps, ros::Publisher updates)
      : maps_(std::move(maps)), updates_(std::move(updates)) {}
  Changes(const Changes&) = delete;
  Changes& operator=(const Changes&) = delete;
  ~Changes() { stop(); }

  void start() {
    stopping_ = false;
    thread_ = std::thread([this] { run(); });
  }
  void stop() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    seen_changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

  /// An answer was on the map with this stamp.
  void saw(ros::Time stamp) {
    {
      const std::lock_guard lock(mutex_);
      seen_ = stamp;
    }
    seen_changed_.notify_all();
  }

  /// The map as it is, while no changes come; its stamp.
  ros::Time put_whole() {
    history_.add({next_stamp(), 0, 0, 0, 0});
    publish(map_);
    return stamp_;
  }

  /// A small map in place of it.
  ros::Time put_another() {
    history_.add({next_stamp(), 0, 0, 0, 0});
    publish(ValueMap(10));
    return stamp_;
  }

  const MapHistory& history() const { return history_; }

  /// Waits for a change after this one, or until the thread of the changes waits for an answer; the number of the
  /// newest.
  int wait_for_one_after(int number) {
    std::unique_lock lock(mutex_);
    published_.wait(lock, [&] { return count_ > number || settling_; });
    return count_;
  }

 private:
  void run() {
    ros::WallRate rate(kRate);
    while (!stopping_) {
      change();
      {
        const std::lock_guard lock(mutex_);
        ++count_;
      }
      published_.notify_all();
      rate.sleep();
    }
  }

  ros::Time next_stamp() { return stamp_ += ros::Duration(1); }

  /// Waits for an answer on the map of the newest stamp.
  void settle(ros::Time stamp) {
    std::unique_lock lock(mutex_);
    settling_ = true;
    published_.notify_all();
    seen_changed_.wait(lock, [&] { return seen_ == stamp || stopping_; });
    settling_ = false;
  }

  void change() {
    const int cells = 5 + static_cast<int>(random_() % 40);
    int x = 0;
    int y = 0;
    do {
      x = static_cast<int>(random_() % (kSide - cells));
      y = static_cast<int>(random_() % (kSide - cells));
    } while (is_near_a_place(x, x + cells) && is_near_a_place(y, y + cells));
    const auto value = static_cast<std::int8_t>(random_() % 3 == 0 ? 100 : 0);
    constexpr int kWhole = 40;
    const bool whole = count_ % kWhole == kWhole - 1;
    if (whole) settle(stamp_);
    const SquareChange made{next_stamp(), x, y, cells, value};
    apply(made, map_);
    history_.add(made);
    if (whole) {
      publish(map_);
      settle(stamp_);
    } else {
      publish(made);
    }
  }

  void publish(const ValueMap& map) {
    nav_msgs::OccupancyGrid grid;
    grid.header.frame_id = "map";
    grid.header.stamp = stamp_;
    grid.info.width = grid.info.height = static_cast<std::uint32_t>(map.side);
    grid.info.resolution = kResolution;
    grid.info.origin.orientation.w = 1;
    grid.data = map.values;
    maps_.publish(grid);
  }

  void publish(const SquareChange& change) {
    map_msgs::OccupancyGridUpdate update;
    update.header.frame_id = "map";
    update.header.stamp = change.stamp;
    update.x = change.x;
    update.y = change.y;
    update.width = update.height = static_cast<std::uint32_t>(change.cells);
    update.data.assign(static_cast<std::size_t>(change.cells * change.cells), change.value);
    updates_.publish(update);
  }

  ros::Publisher maps_;
  ros::Publisher updates_;
  ValueMap map_ = first_map();
  std::mt19937 random_{2};
  ros::Time stamp_ = ros::Time(1000);
  MapHistory history_;
  std::mutex mutex_;
  std::condition_variable published_;
  std::condition_variable seen_changed_;
  ros::Time seen_;         // the stamp of the last answer
  bool settling_ = false;  // until it is that of the newest message
  int count_ = 0;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

constexpr std::array kPlanners{"astar", "jps", "replanner"};

PlanRequest random_request(std::mt19937& random) {
  const auto place = [&] { return metres(kPlaces[random() % kPlaces.size()]); };
  PlanRequest asked = request(place(), place());
  asked.start = pose(place(), place());
  asked.planner = kPlanners[random() % kPlanners.size()];
  return asked;
}

class ChangingMap : public testing::Test {
 protected:
  ChangingMap()
      : goals_(node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1)),
        client_(node_.serviceClient<PlanPath>("plan_path")),
        changes_(node_.advertise<nav_msgs::OccupancyGrid>("map", 100, true),
                 node_.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 100)),
        results_(node_.subscribe<PlanResult>(
            "plan_result", 1000, [this](const PlanResultConstPtr& result) {
              replanned_.check(*result, start_.pose.position, goal_.pose.position);
            })) {}

  void SetUp() override {
    ASSERT_TRUE(client_.waitForExistence(kPatience));
    const ros::Time stamp = changes_.put_whole();
    ASSERT_TRUE(wait_until([&] {
      return goals_.getNumSubscribers() > 0 && results_.getNumPublishers() > 0 &&
             ask(random_request(random_)).map_stamp == stamp;
    }));
    pid_ = pid_of("/planner_server");
    ASSERT_GT(pid_, 0);
    goals_.publish(goal_);
  }

  PlanResult ask(const PlanRequest& request) {
    PlanPath call;
    call.request.request = request;
    EXPECT_TRUE(client_.call(call));
    return call.response.result;
  }

  /// Changes the map for so many seconds, and asks for a plan after every change.
  void change_for(double seconds) {
    changes_.start();
    const ros::WallTime begin = ros::WallTime::now();
    const auto elapsed = [&] { return (ros::WallTime::now() - begin).toSec(); };
    const double cpu_before = cpu_seconds_of(pid_);
    while (elapsed() < seconds) {
      count_ = changes_.wait_for_one_after(count_);
      const PlanRequest asked = random_request(random_);
      const PlanResult result = ask(asked);
      served_.check(result, asked.start.pose.position, asked.goals[0].pose.position);
      changes_.saw(result.map_stamp);
      peak_ = std::max(peak_, memory_of(pid_));
    }
    cores_ = std::max(cores_, (cpu_seconds_of(pid_) - cpu_before) / elapsed());
    changes_.stop();
  }

  /// The node's memory, MB, after it had another map and has each planner once again.
  double settled_memory() {
    const auto wait_for = [this](ros::Time stamp) {
      return wait_until([&] {
        return ask(random_request(random_)).map_stamp == stamp && replanned_.last_stamp() == stamp;
      });
    };
    EXPECT_TRUE(wait_for(changes_.put_another()));
    EXPECT_TRUE(wait_for(changes_.put_whole()));
    for (const char* planner : kPlanners) {
      PlanRequest asked = request(metres(kPlaces[1]), metres(kPlaces[2]));
      asked.planner = planner;
      ask(asked);
    }
    return memory_of(pid_);
  }

  const geometry_msgs::PoseStamped start_ = pose(metres(kPlaces.front()), metres(kPlaces.front()));
  const geometry_msgs::PoseStamped goal_ = pose(metres(kPlaces.back()), metres(kPlaces.back()));
  ros::NodeHandle node_;
  ros::Publisher goals_;
  ros::ServiceClient client_;
  std::mt19937 random_{3};
  int pid_ = 0;
  int count_ = 0;
  double peak_ = 0;   // MB
  double cores_ = 0;  // the most
  Changes changes_;
  CheckedAnswers served_{changes_.history(), first_map()};
  CheckedAnswers replanned_{changes_.history(), first_map()};
  ros::Subscriber results_;  // last: it uses the others
};

TEST_F(ChangingMap, EveryAnswerIsFreeOnItsMapAndTheNodeStaysSmall) {
  const double seconds = ros::NodeHandle("~").param("seconds", 60.0);
  change_for(seconds / 4);
  const double warm = settled_memory();
  change_for(3 * seconds / 4);
  const double late = settled_memory();
  results_.shutdown();

  std::cout << count_ << " changes; " << served_.answers() << " answers (" << served_.found()
            << " found), " << served_.age() << " ms after the change; " << replanned_.answers()
            << " plans made again (" << replanned_.found() << " found), " << replanned_.age()
            << " ms after it; memory " << warm << " MB, later " << late << " MB, at most " << peak_
            << " MB; " << cores_ << " cores; " << served_.flooded() + replanned_.flooded()
            << " without a path flooded\n";
  EXPECT_EQ(served_.fault(), "");
  EXPECT_EQ(replanned_.fault(), "");
  EXPECT_GT(served_.found(), served_.answers() / 2);
  EXPECT_GT(replanned_.found(), 0);
  EXPECT_LT(late, warm + kGrowth);
  EXPECT_LT(peak_, kPeak);
  EXPECT_LE(cores_, 1);
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "changing_map_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
