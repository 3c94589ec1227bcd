#include "wend_ros/map_sensor.hpp"

#include <optional>
#include <utility>

#include "wend/io/map/load_map.hpp"
#include "wend_ros/map_message.hpp"

namespace wend_ros {
namespace {

constexpr const char* kFrame = "map";

/// A map as messages have it: y up.
wend::Expected<wend::GridMap, std::string> load(const std::string& file) {
  const auto loaded = wend::load_map(file);
  if (!loaded) return wend::Unexpected<std::string>(loaded.error().message);
  for (const std::string& note : loaded->notes) ROS_WARN_STREAM(file << ": " << note);
  return *map_from(to_message(loaded->map, kFrame),
                   {.occupied_from = kOccupiedValue, .rough = true});
}

}  // namespace

wend::Expected<SensedMap, std::string> sensed_map_of(const ros::NodeHandle& own) {
  auto truth = load(own.param<std::string>("map", ""));
  if (!truth) return wend::Unexpected<std::string>("~map: " + truth.error());
  std::optional<wend::GridMap> known;
  if (const auto file = own.param<std::string>("known", ""); !file.empty()) {
    auto loaded = load(file);
    if (!loaded) return wend::Unexpected<std::string>("~known: " + loaded.error());
    known = *std::move(loaded);
  }
  auto map = SensedMap::make(*std::move(truth), std::move(known));
  if (!map) return wend::Unexpected<std::string>("~known: " + map.error().message);
  return *std::move(map);
}

MapSensor::MapSensor(ros::NodeHandle& node, SensedMap map, double range)
    : map_(std::move(map)),
      range_(range),
      truths_(node.advertise<nav_msgs::OccupancyGrid>("true_map", 1, true)) {
  // Who connects to either topic gets the whole map: updates before that are in it.
  maps_ = node.advertise<nav_msgs::OccupancyGrid>(
      "map", 1, [this](const ros::SingleSubscriberPublisher& one) { one.publish(known()); });
  constexpr std::uint32_t kMostUpdates = 1000;
  updates_ = node.advertise<map_msgs::OccupancyGridUpdate>(
      "map_updates", kMostUpdates,
      [this](const ros::SingleSubscriberPublisher&) { maps_.publish(known()); });
  truths_.publish(to_message(map_.truth(), kFrame));
}

nav_msgs::OccupancyGrid MapSensor::known() const {
  nav_msgs::OccupancyGrid message = to_message(map_.known(), kFrame);
  message.header.stamp = ros::Time::now();
  return message;
}

void MapSensor::look(const wend::MapPose& robot) {
  const wend::CellBox changed = map_.look(robot.point(), range_);
  if (changed.empty()) return;
  map_msgs::OccupancyGridUpdate update = update_message(map_.known(), changed, kFrame);
  update.header.stamp = ros::Time::now();
  updates_.publish(update);
}

}  // namespace wend_ros
