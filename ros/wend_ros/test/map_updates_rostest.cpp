// planner_server on a map that changes: updates, whole maps, costmaps, and plans that are made again.

#include <dynamic_reconfigure/Reconfigure.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <wend_ros/PlanPath.h>

#include <mutex>
#include <string>
#include <vector>

#include "next_message.hpp"
#include "planner_client.hpp"

namespace wend_ros {
namespace {

constexpr std::uint32_t kSide = 20;

/// Messages of a map of free cells of 1 m, each with a stamp of its own.
class MapTopic {
 public:
  explicit MapTopic(const std::string& name)
      : maps_(node_.advertise<nav_msgs::OccupancyGrid>(name, 1, true)),
        updates_(node_.advertise<map_msgs::OccupancyGridUpdate>(name + "_updates", 100)) {}

  bool connected() const {
    return maps_.getNumSubscribers() > 0 && updates_.getNumSubscribers() > 0;
  }

  ros::Time put_map(std::uint32_t side = kSide, std::int8_t value = 0) {
    const nav_msgs::OccupancyGrid grid = map_of(next_stamp(), side, value);
    maps_.publish(grid);
    return grid.header.stamp;
  }

  /// A map of free cells but for one, with that stamp.
  void put_map_with(ros::Time stamp, std::uint32_t x, std::uint32_t y) {
    nav_msgs::OccupancyGrid grid = map_of(stamp, kSide, 0);
    grid.data[y * kSide + x] = 100;
    maps_.publish(grid);
  }

  /// Between those of the messages before and after this.
  ros::Time next_stamp() { return stamp_ += ros::Duration(1); }

  /// All cells of the rectangle have that value.
  ros::Time put(int x, int y, std::uint32_t width, std::uint32_t height, int value) {
    return send(x, y, width, height, std::size_t{width} * height, value, "map");
  }

  ros::Time send(int x, int y, std::uint32_t width, std::uint32_t height, std::size_t values,
                 int value, const std::string& frame_id) {
    return send_at(next_stamp(), x, y, width, height, values, value, frame_id);
  }

  ros::Time send_at(ros::Time stamp, int x, int y, std::uint32_t width, std::uint32_t height,
                    std::size_t values, int value, const std::string& frame_id) {
    map_msgs::OccupancyGridUpdate update;
    update.header.stamp = stamp;
    update.header.frame_id = frame_id;
    update.x = x;
    update.y = y;
    update.width = width;
    update.height = height;
    update.data.assign(values, static_cast<std::int8_t>(value));
    updates_.publish(update);
    return update.header.stamp;
  }

 private:
  static nav_msgs::OccupancyGrid map_of(ros::Time stamp, std::uint32_t side, std::int8_t value) {
    nav_msgs::OccupancyGrid grid;
    grid.header.frame_id = "map";
    grid.header.stamp = stamp;
    grid.info.width = grid.info.height = side;
    grid.info.resolution = 1;
    grid.info.origin.orientation.w = 1;
    grid.data.assign(std::size_t{side} * side, value);
    return grid;
  }

  ros::NodeHandle node_;
  ros::Publisher maps_;
  ros::Publisher updates_;
  static ros::Time stamp_;  // no test goes back behind the one before
};

ros::Time MapTopic::stamp_ = ros::Time(1000);

class MapUpdates : public testing::Test {
 protected:
  MapUpdates() : map_("map"), costmap_("costmap/costmap") {}

  void SetUp() override {
    client_ = node_.serviceClient<PlanPath>("plan_path");
    coarse_ = node_.serviceClient<PlanPath>("coarse/plan_path");
    goals_ = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1);
    cancels_ = node_.advertise<std_msgs::Empty>("cancel", 1);
    results_ =
        node_.subscribe<PlanResult>("plan_result", 100, [this](const PlanResultConstPtr& one) {
          const std::lock_guard lock(mutex_);
          seen_.push_back(*one);
        });
    ASSERT_TRUE(client_.waitForExistence(kPatience));
    ASSERT_TRUE(coarse_.waitForExistence(kPatience));
    ASSERT_TRUE(wait_until([this] {
      return map_.connected() && costmap_.connected() && goals_.getNumSubscribers() > 0 &&
             cancels_.getNumSubscribers() > 0 && results_.getNumPublishers() > 0;
    }));
    ASSERT_TRUE(wait_for(map_.put_map(kSide + 1)));
    ASSERT_TRUE(wait_for(map_.put_map()));
  }

  void TearDown() override {
    set_replan("ahead");
    cancels_.publish(std_msgs::Empty());
  }

  static PlanResult ask(ros::ServiceClient& client, const PlanRequest& request) {
    PlanPath call;
    call.request.request = request;
    EXPECT_TRUE(client.call(call));
    return call.response.result;
  }

  /// From (1.5,1.5) to (18.5,1.5).
  PlanResult plan() { return ask(client_, request(18.5, 1.5)); }

  /// Waits until answers are on the map with this stamp, which is the newest.
  bool wait_for(ros::Time stamp) {
    return wait_until([&] { return plan().map_stamp == stamp; });
  }

  static void set_replan(const std::string& value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.strs.resize(1);
    call.request.config.strs[0].name = "replan_on_change";
    call.request.config.strs[0].value = value;
    EXPECT_TRUE(ros::service::call("planner_server/set_parameters", call));
  }

  static void set_rough(bool value, double cost_factor) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(1);
    call.request.config.doubles[0].name = "cost_factor";
    call.request.config.doubles[0].value = cost_factor;
    call.request.config.bools.resize(1);
    call.request.config.bools[0].name = "rough";
    call.request.config.bools[0].value = value ? 1 : 0;
    EXPECT_TRUE(ros::service::call("planner_server/set_parameters", call));
  }

  /// The stamps of the maps of all plans for topics since the last call.
  std::vector<ros::Time> planned() {
    const std::lock_guard lock(mutex_);
    std::vector<ros::Time> stamps;
    for (const PlanResult& result : seen_) stamps.push_back(result.map_stamp);
    return stamps;
  }

  PlanResult last() {
    const std::lock_guard lock(mutex_);
    return seen_.empty() ? PlanResult() : seen_.back();
  }

  /// A goal to which the straight path leads along the row of the start, for each test another.
  void go() {
    static double x = 18.5;
    x -= 1;
    goals_.publish(pose(x, 1.5));
    ASSERT_TRUE(wait_until([this] {
      const PlanResult result = last();
      return result.status_name == "found" && result.path.poses.back().pose.position.x == x;
    }));
    const std::lock_guard lock(mutex_);
    seen_.clear();
  }

  ros::NodeHandle node_;
  MapTopic map_;
  MapTopic costmap_;
  ros::ServiceClient client_;
  ros::ServiceClient coarse_;
  ros::Publisher goals_;
  ros::Publisher cancels_;
  ros::Subscriber results_;
  std::mutex mutex_;
  std::vector<PlanResult> seen_;
};

TEST_F(MapUpdates, AreInTheNextAnswer) {
  const PlanResult before = plan();
  EXPECT_NEAR(before.cost, 17, 1e-9);
  ASSERT_TRUE(wait_for(map_.put(10, 0, 1, 15, 100)));
  const PlanResult after = plan();
  EXPECT_GT(after.cost, 30) << "around the wall";
  EXPECT_GT(after.map_version, before.map_version);
  EXPECT_GT(after.since_change, 0);
  ASSERT_TRUE(wait_for(map_.put(0, 14, kSide, 1, 100)));
  EXPECT_EQ(plan().status_name, "no_valid_path");
  ASSERT_TRUE(wait_for(map_.put(10, 1, 1, 1, 0)));
  EXPECT_NEAR(plan().cost, 17, 1e-9);
}

TEST_F(MapUpdates, AWholeMapThatLiesAsTheOneBeforeIsAnEditToo) {
  const PlanResult before = plan();
  ASSERT_TRUE(wait_for(map_.put_map()));
  const PlanResult same = plan();
  EXPECT_EQ(same.map_version, before.map_version) << "nothing has changed";
  EXPECT_GT(same.since_change, before.since_change);
  ASSERT_TRUE(wait_for(map_.put_map(kSide, 100)));
  const PlanResult after = plan();
  EXPECT_EQ(after.status_name, "start_blocked");
  EXPECT_EQ(after.map_version, before.map_version + 1) << "one edit";
}

TEST_F(MapUpdates, ThatDoNotFitChangeNothing) {
  const PlanResult before = plan();
  map_.put(15, 0, 6, 2, 100);                         // over the edge
  map_.put(-1, 1, 5, 1, 100);                         // the same
  map_.send(5, 1, 3, 1, 2, 100, "map");               // a value too few
  map_.send(5, 1, 3, 1, 4, 100, "map");               // a value too many
  map_.send(5, 1, 3, 1, 3, 100, "odom");              // in another frame
  map_.send(0, 0, 4'000'000'000U, 2, 5, 100, "map");  // absurd
  ASSERT_TRUE(wait_for(map_.put(19, 19, 1, 1, 100))) << "they come in order";
  const PlanResult after = plan();
  EXPECT_EQ(after.cost, before.cost);
  EXPECT_EQ(after.map_version, before.map_version + 1);
}

TEST_F(MapUpdates, AnotherMapAfterThemCounts) {
  ASSERT_TRUE(wait_for(map_.put(10, 0, 1, kSide, 100)));
  EXPECT_EQ(plan().status_name, "no_valid_path");
  ASSERT_TRUE(wait_for(map_.put_map(kSide + 5)));
  EXPECT_NEAR(plan().cost, 17, 1e-9);
}

TEST_F(MapUpdates, AreNeverRemovedByAMapThatIsOlder) {
  const ros::Time before = map_.next_stamp();
  const ros::Time wall = map_.put(10, 0, 1, kSide, 100);
  ASSERT_TRUE(wait_for(wall));
  map_.put_map_with(before, 5, 15);
  ASSERT_TRUE(wait_until([&] {
    return ask(client_, request(5.5, 15.5)).status_name == "goal_blocked";
  })) << "where nothing newer came, it counts";
  const PlanResult result = plan();
  EXPECT_EQ(result.status_name, "no_valid_path") << "through the wall";
  EXPECT_EQ(result.map_stamp, wall) << "the newest message in the map";
}

TEST_F(MapUpdates, ThatAreOlderThanTheMapAreNotUsed) {
  const ros::Time before = map_.next_stamp();
  ASSERT_TRUE(wait_for(map_.put_map(kSide + 5)));
  map_.send_at(before, 10, 0, 1, kSide, kSide, 100, "map");
  const ros::Time elsewhere = map_.put(0, 19, 1, 1, 100);
  ASSERT_TRUE(wait_for(elsewhere)) << "they come in order";
  EXPECT_EQ(plan().status_name, "found");
}

TEST_F(MapUpdates, AreReadAnewWhenTheirMeaningChanges) {
  ASSERT_TRUE(wait_for(map_.put(10, 0, 1, kSide, 50)));
  EXPECT_NEAR(plan().cost, 17, 1e-9);
  set_rough(true, 4);
  EXPECT_NEAR(plan().cost, 19, 0.01) << "at once, without another map";
  set_rough(true, 1);
  EXPECT_NEAR(plan().cost, 17.5, 0.01);
  set_rough(false, 4);
  EXPECT_NEAR(plan().cost, 17, 1e-9);
}

TEST_F(MapUpdates, ThatTouchThePathAheadAreAReasonToPlanAgain) {
  go();
  const ros::Time elsewhere = map_.put(5, 10, 3, 3, 100);
  ASSERT_TRUE(wait_for(elsewhere));
  const ros::Time on_the_path = map_.put(10, 0, 1, 5, 100);
  ASSERT_TRUE(wait_until([&] { return last().map_stamp == on_the_path; }));
  EXPECT_GT(last().cost, last().path.poses.back().pose.position.x) << "around it";
  EXPECT_LT(last().since_change, 10);
  EXPECT_EQ(planned(), std::vector{on_the_path}) << "the other one does not touch the path";
}

TEST_F(MapUpdates, AreAllAReasonToPlanAgainWhileThereIsNoPath) {
  go();
  const ros::Time wall = map_.put(10, 0, 1, kSide, 100);
  ASSERT_TRUE(wait_until([&] { return last().map_stamp == wall; }));
  EXPECT_EQ(last().status_name, "no_valid_path");
  const ros::Time door = map_.put(10, 18, 1, 1, 0);
  ASSERT_TRUE(wait_until([&] { return last().map_stamp == door; }));
  EXPECT_EQ(last().status_name, "found");
}

TEST_F(MapUpdates, AreAllAReasonToPlanAgainIfToldSo) {
  set_replan("always");
  go();
  const ros::Time elsewhere = map_.put(5, 10, 3, 3, 100);
  EXPECT_TRUE(wait_until([&] { return last().map_stamp == elsewhere; }));
}

TEST_F(MapUpdates, AreNoReasonToPlanAgainIfToldSo) {
  set_replan("never");
  go();
  const ros::Time on_the_path = map_.put(10, 0, 1, 5, 100);
  ASSERT_TRUE(wait_for(on_the_path));
  const ros::Time later = map_.put(19, 19, 1, 1, 100);
  ASSERT_TRUE(wait_for(later));
  goals_.publish(pose(12.5, 1.5));
  ASSERT_TRUE(wait_until([&] { return last().map_stamp == later; }));
  EXPECT_EQ(planned().size(), 1U) << "the goal is one";
}

TEST_F(MapUpdates, OfACostmapAreReadAsCosts) {
  const auto answer = [this] { return ask(coarse_, request(18.5, 1.5)); };
  const ros::Time stamp = costmap_.put_map();
  ASSERT_TRUE(wait_until([&] { return answer().map_stamp == stamp; }));
  EXPECT_NEAR(answer().cost, 17, 1e-9);
  const ros::Time dear = costmap_.put(10, 0, 1, kSide, 98);
  ASSERT_TRUE(wait_until([&] { return answer().map_stamp == dear; }));
  EXPECT_NEAR(answer().cost, 17 + 4 * 0.98, 0.01) << "98 is no obstacle there";
  const ros::Time inscribed = costmap_.put(10, 0, 1, kSide, 99);
  ASSERT_TRUE(wait_until([&] { return answer().map_stamp == inscribed; }));
  EXPECT_EQ(answer().status_name, "no_valid_path");
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_updates_rostest");
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
