#include "wend_ros/map_feed.hpp"

#include <sstream>
#include <utility>

#include "wend/io/map/load_map.hpp"
#include "wend_ros/map_message.hpp"

namespace wend_ros {
namespace {

constexpr int kInscribed = 99;  // costmap_2d's: the robot's centre may not be there

/// Each changes the map: none may get lost while an edit runs.
constexpr std::uint32_t kMostUpdates = 1000;

/// ~masks: a list, or a text with commas between the masks. Anything else is a mask that cannot be read.
std::vector<std::string> mask_specs(const ros::NodeHandle& own) {
  XmlRpc::XmlRpcValue value;
  if (!own.getParam("masks", value)) return {};
  std::vector<std::string> specs;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeString) {
    std::istringstream words(static_cast<std::string>(value));
    for (std::string word; std::getline(words, word, ',');) {
      if (!word.empty()) specs.push_back(word);
    }
    return specs;
  }
  if (value.getType() != XmlRpc::XmlRpcValue::TypeArray) return {value.toXml()};
  for (int i = 0; i < value.size(); ++i) {
    const bool is_text = value[i].getType() == XmlRpc::XmlRpcValue::TypeString;
    specs.push_back(is_text ? static_cast<std::string>(value[i]) : value[i].toXml());
  }
  return specs;
}

Stamp stamp_of(const std_msgs::Header& header) { return static_cast<Stamp>(header.stamp.toNSec()); }

Masks masks_of(const ros::NodeHandle& own) {
  Masks masks = Masks::of(mask_specs(own));
  for (const std::string& fault : masks.faults()) ROS_ERROR_STREAM("~masks: " << fault);
  for (const std::string& note : masks.notes()) ROS_WARN_STREAM("~masks: " << note);
  return masks;
}

}  // namespace

MapFeed::MapFeed(ros::NodeHandle& node, ros::NodeHandle& own, wend::Session& session,
                 const CostReading& costs, std::function<void(const Change&)> changed)
    : session_(session),
      changed_(std::move(changed)),
      costmap_(own.param("costmap", false)),
      occupied_from_(
          own.param("occupied_from", costmap_ ? kInscribed : MapReading{}.occupied_from)),
      topic_(node.resolveName("map")),
      map_(reading_of(costs)),
      masks_(masks_of(own)) {
  load(own);
  subscribers_ = {node.subscribe(topic_, 1, &MapFeed::take_map, this),
                  node.subscribe(topic_ + "_updates", kMostUpdates, &MapFeed::take_update, this)};
}

void MapFeed::load(const ros::NodeHandle& own) {
  const auto file = own.param<std::string>("map", "");
  if (file.empty()) return;
  const auto loaded = wend::load_map(file);
  if (!loaded) {
    ROS_ERROR_STREAM("~map: " << loaded.error().message);
    session_.clear_map(loaded.error().message);
    return;
  }
  for (const std::string& note : loaded->notes) ROS_WARN_STREAM("~map: " << file << ": " << note);
  take_map(to_message(loaded->map, own.param<std::string>("frame_id", "map")));
}

wend::Expected<MapFeed::Now, wend::Error> MapFeed::now() const {
  const std::lock_guard lock(mutex_);
  auto view = session_.view();
  if (!view) return wend::Unexpected<wend::Error>(std::move(view.error()));
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(map_.stamp()));
  return Now{*std::move(view), stamp, change_time_, heard_};
}

MapReading MapFeed::reading_of(const CostReading& costs) const {
  return {.occupied_from = occupied_from_,
          .rough = costs.rough || costmap_,
          .cost_factor = costs.cost_factor};
}

void MapFeed::set_costs(const CostReading& costs) {
  const auto reread = [&]() -> std::optional<Change> {
    const std::lock_guard lock(mutex_);
    if (!map_.read_as(reading_of(costs))) return {};
    return put_whole(map_.whole(), std::chrono::steady_clock::now());
  };
  if (const auto change = reread()) changed_(*change);
}

void MapFeed::take_map(const nav_msgs::OccupancyGrid& message) {
  if (const auto change = put(message)) changed_(*change);
}

void MapFeed::take_update(const map_msgs::OccupancyGridUpdate& message) {
  if (const auto change = put(message)) changed_(*change);
}

wend::Expected<OccupancyMap::Change, wend::Error> MapFeed::take(
    const nav_msgs::OccupancyGrid& message) {
  auto layout = layout_of(message);
  if (!layout) return wend::Unexpected<wend::Error>(std::move(layout.error()));
  return map_.take(*std::move(layout), message.data, stamp_of(message.header));
}

std::optional<MapFeed::Change> MapFeed::put(const nav_msgs::OccupancyGrid& message) {
  const auto came = std::chrono::steady_clock::now();
  const std::lock_guard lock(mutex_);
  heard_ = came;
  auto taken = take(message);
  if (!taken) {
    ROS_ERROR_STREAM(topic_ << ": " << taken.error().message);
    map_.clear();
    session_.clear_map(taken.error().message);
    return std::nullopt;
  }
  if (taken->keeps_newer && !std::exchange(told_order_, true)) {
    ROS_WARN_STREAM(topic_ << ": a map is older than updates that came before it, which lie over "
                              "it; this is said once");
  }
  if (!taken->whole) return edit(taken->edit, came);
  ROS_INFO_STREAM(topic_ << ": " << message.info.width << " x " << message.info.height
                         << " cells in the frame '" << message.header.frame_id << "'");
  return put_whole(*std::move(taken->whole), came);
}

std::optional<MapFeed::Change> MapFeed::put(const map_msgs::OccupancyGridUpdate& message) {
  const auto came = std::chrono::steady_clock::now();
  const std::lock_guard lock(mutex_);
  heard_ = came;
  const auto taken = map_.take(update_of(message), stamp_of(message.header));
  if (!taken) {
    ROS_WARN_STREAM_THROTTLE(
        1, topic_ << "_updates: an update is not used: " << taken.error().message);
    return std::nullopt;
  }
  return edit(*taken, came);
}

/// Nothing if a mask does not fit: then there is no map.
std::optional<MapFeed::Change> MapFeed::put_whole(wend::GridMap map, TimePoint came) {
  change_time_ = came;
  auto under_masks = masks_.lay_over(std::move(map));
  if (!under_masks) {
    ROS_ERROR_STREAM(topic_ << ": " << under_masks.error().message);
    session_.clear_map(under_masks.error().message);
    return std::nullopt;
  }
  session_.set_map(*under_masks, map_.layout().frame_id);
  return Change{.whole = *std::move(under_masks), .frame_id = map_.layout().frame_id};
}

/// Nothing if the map stays as it is.
std::optional<MapFeed::Change> MapFeed::edit(const wend::MapEdit& edit, TimePoint came) {
  if (is_empty(edit)) return std::nullopt;
  auto change = session_.edit(masks_.over(edit));
  // There is no space to edit for an invalid robot; a later one needs the map all the same.
  if (!change) return put_whole(map_.whole(), came);
  change_time_ = came;
  auto view = session_.view();
  if (!view) return std::nullopt;
  return Change{
      .edited = *std::move(view), .cells = *std::move(change), .frame_id = map_.layout().frame_id};
}

}  // namespace wend_ros
