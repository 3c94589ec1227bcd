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
#include <limits>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "map_history.hpp"
#include "next_message.hpp"
#include "planner_client.hpp"
#include "process_of_node.hpp"
#include "process_usage.hpp"

namespace wend_ros {
namespace {

constexpr int kSide = 1000;
constexpr double kResolution = 0.05;
constexpr double kRadius = 0.3;  // as in changing_map.test
constexpr double kRate = 20;     // Hz
constexpr double kWindow =
    0.2;  // of the time: memory in the second fifth is compared with that in the last
constexpr double kGrowth = 10;  // MB
constexpr double kPeak = 200;   // MB

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
/// 40th change comes as a whole map.
class Changes {
 public:
  Changes(ros::Publisher maps, ros::Publisher updates)
      : maps_(std::move(maps)), updates_(std::move(updates)) {
    history_.add({next_stamp(), 0, 0, 0, 0});
    publish_map();
  }
  Changes(const Changes&) = delete;
  Changes& operator=(const Changes&) = delete;
  ~Changes() { stop(); }

  void start() {
    thread_ = std::thread([this] { run(); });
  }
  void stop() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }

  const MapHistory& history() const { return history_; }

  /// Waits for a change after this one; the number of the newest.
  int wait_for_one_after(int number) {
    std::unique_lock lock(mutex_);
    published_.wait(lock, [&] { return count_ > number; });
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

  void change() {
    const int cells = 5 + static_cast<int>(random_() % 40);
    int x = 0;
    int y = 0;
    do {
      x = static_cast<int>(random_() % (kSide - cells));
      y = static_cast<int>(random_() % (kSide - cells));
    } while (is_near_a_place(x, x + cells) && is_near_a_place(y, y + cells));
    const auto value = static_cast<std::int8_t>(random_() % 3 == 0 ? 100 : 0);
    const SquareChange made{next_stamp(), x, y, cells, value};
    apply(made, map_);
    history_.add(made);
    constexpr int kWhole = 40;
    if (count_ % kWhole == kWhole - 1) {
      publish_map();
    } else {
      publish(made);
    }
  }

  void publish_map() {
    nav_msgs::OccupancyGrid grid;
    grid.header.frame_id = "map";
    grid.header.stamp = stamp_;
    grid.info.width = grid.info.height = kSide;
    grid.info.resolution = kResolution;
    grid.info.origin.orientation.w = 1;
    grid.data = map_.values;
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
  int count_ = 0;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// Is the robot's disc free of occupied cells with its middle there? Cell by cell.
bool is_free(const ValueMap& map, double x, double y) {
  const double radius = kRadius / kResolution;
  const int reach = static_cast<int>(radius) + 1;
  for (int row = static_cast<int>(y) - reach; row <= static_cast<int>(y) + reach; ++row) {
    for (int column = static_cast<int>(x) - reach; column <= static_cast<int>(x) + reach;
         ++column) {
      const bool inside = column >= 0 && row >= 0 && column < map.side && row < map.side;
      if (inside && map.at(column, row) != 100) continue;
      const double dx = std::max({column - x, x - column - 1, 0.0});
      const double dy = std::max({row - y, y - row - 1, 0.0});
      if (std::hypot(dx, dy) < radius - 1e-6) return false;
    }
  }
  return true;
}

/// Counts answers, and those that are wrong: not free on the map that they name, or without such a map.
class Checked {
 public:
  explicit Checked(const MapHistory& history) : replay_(history, first_map()) {}

  void check(const PlanResult& result) {
    const std::lock_guard lock(mutex_);
    ++answers_;
    if (!replay_.go_to(result.map_stamp)) return fail("the map of its stamp was not published");
    if (result.status != 0) return;
    ++found_;
    ages_.push_back(result.since_change);
    for (const auto& stamped : result.path.poses) {
      const auto& at = stamped.pose.position;
      if (!is_free(replay_.map(), at.x / kResolution, at.y / kResolution)) {
        return fail("not free at " + std::to_string(at.x) + ',' + std::to_string(at.y));
      }
    }
  }

  int answers() const { return answers_; }
  int found() const { return found_; }
  std::string fault() const { return fault_; }

  /// The median of the time since the change, ms.
  double age() {
    if (ages_.empty()) return 0;
    const auto middle = ages_.begin() + static_cast<std::ptrdiff_t>(ages_.size() / 2);
    std::nth_element(ages_.begin(), middle, ages_.end());
    return 1e3 * *middle;
  }

 private:
  void fail(const std::string& what) {
    if (fault_.empty()) fault_ = "answer " + std::to_string(answers_) + ": " + what;
  }

  std::mutex mutex_;
  MapReplay replay_;
  int answers_ = 0;
  int found_ = 0;
  std::string fault_;
  std::vector<double> ages_;
};

/// Times and values.
using Samples = std::vector<std::pair<double, double>>;

/// The least value between two times: what is used for a moment, as to explain why there is no path, does not count.
double least(const Samples& samples, double from, double to) {
  double found = std::numeric_limits<double>::infinity();
  for (const auto& [time, value] : samples) {
    if (time >= from && time < to) found = std::min(found, value);
  }
  return found;
}

PlanRequest random_request(std::mt19937& random) {
  const auto place = [&] { return metres(kPlaces[random() % kPlaces.size()]); };
  PlanRequest asked = request(place(), place());
  asked.start = pose(place(), place());
  constexpr std::array kPlanners{"astar", "jps", "replanner"};
  asked.planner = kPlanners[random() % kPlanners.size()];
  return asked;
}

TEST(ChangingMap, EveryAnswerIsFreeOnItsMapAndTheNodeStaysSmall) {
  ros::NodeHandle node;
  const double seconds = ros::NodeHandle("~").param("seconds", 60.0);
  auto goals = node.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
  Changes changes(node.advertise<nav_msgs::OccupancyGrid>("map", 100, true),
                  node.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 100));
  Checked served(changes.history());
  Checked replanned(changes.history());
  const auto results = node.subscribe<PlanResult>(
      "plan_result", 1000, [&](const PlanResultConstPtr& result) { replanned.check(*result); });
  ros::ServiceClient client = node.serviceClient<PlanPath>("plan_path");
  ASSERT_TRUE(client.waitForExistence(kPatience));
  std::mt19937 random(3);
  const auto ask = [&] {
    PlanPath call;
    call.request.request = random_request(random);
    EXPECT_TRUE(client.call(call));
    return call.response.result;
  };
  ASSERT_TRUE(wait_until([&] { return goals.getNumSubscribers() > 0 && ask().map_version > 0; }));
  ASSERT_TRUE(wait_until([&] { return results.getNumPublishers() > 0; }));
  const int pid = pid_of("/planner_server");
  ASSERT_GT(pid, 0);
  goals.publish(pose(metres(950), metres(950)));

  changes.start();
  const ros::WallTime begin = ros::WallTime::now();
  const auto elapsed = [&] { return (ros::WallTime::now() - begin).toSec(); };
  const double cpu_before = cpu_seconds_of(pid);
  Samples memory;  // MB
  int number = 0;
  while (elapsed() < seconds) {
    number = changes.wait_for_one_after(number);
    served.check(ask());
    memory.emplace_back(elapsed(), memory_of(pid));
  }
  const double cores = (cpu_seconds_of(pid) - cpu_before) / elapsed();
  changes.stop();

  const double warm = least(memory, kWindow * seconds, 2 * kWindow * seconds);
  const double late = least(memory, (1 - kWindow) * seconds, seconds + 1);
  double peak = 0;
  for (const auto& [time, value] : memory) peak = std::max(peak, value);
  std::cout << number << " changes; " << served.answers() << " answers (" << served.found()
            << " found), " << served.age() << " ms after the change; " << replanned.answers()
            << " plans made again (" << replanned.found() << " found), " << replanned.age()
            << " ms after it; memory " << warm << " MB, later " << late << " MB, at most " << peak
            << " MB; " << cores << " cores\n";
  EXPECT_EQ(served.fault(), "");
  EXPECT_EQ(replanned.fault(), "");
  EXPECT_GT(served.found(), served.answers() / 2);
  EXPECT_GT(replanned.found(), 0);
  EXPECT_LT(late, warm + kGrowth);
  EXPECT_LT(peak, kPeak);
  EXPECT_LE(cores, 1);
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
