#pragma once

// MapFeed: fills a session with the map of /map and /map_updates. The second topic has the name of the first and
// `_updates` behind it, as with costmap_2d and rviz. An update, and a map that lies as the one before, edit
// the session's map, so that its planners stay.
//
//   MapFeed feed(node, own, session, costs, [&](const MapFeed::Change& change) { replan(change); });
//   const auto now = feed.now();

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/robot/space_change.hpp"
#include "wend/session/session.hpp"
#include "wend_ros/masks.hpp"
#include "wend_ros/occupancy_map.hpp"

namespace wend_ros {

class MapFeed {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// What values below the threshold cost.
  struct CostReading {
    bool rough;          // false: they are free; ~costmap reads them as rough all the same
    double cost_factor;  // a rough one v costs 1 + cost_factor v / 100
  };

  struct Change {
    std::optional<wend::GridMap> whole = {};         // another map
    std::optional<wend::Session::View> edited = {};  // else the map after an edit
    wend::SpaceChange cells = {};                    // and what that has changed
    std::string frame_id = {};
  };

  /// The map at one moment.
  struct Now {
    wend::Session::View view;
    ros::Time stamp;    // of the newest message in it
    TimePoint changed;  // when the newest one came that changed it
    TimePoint heard;    // when the newest one came
  };

  /// Reads ~occupied_from, ~costmap, ~masks, ~map (a file) and ~frame_id. `costs`: what values below the
  /// threshold cost. `changed` is called after every change, from the thread that took it.
  MapFeed(ros::NodeHandle& node, ros::NodeHandle& own, wend::Session& session,
          const CostReading& costs, std::function<void(const Change&)> changed);

  /// Fails as Session::view() does.
  wend::Expected<Now, wend::Error> now() const;

  void set_costs(const CostReading& costs);

 private:
  MapReading reading_of(const CostReading& costs) const;
  void load(const ros::NodeHandle& own);
  void take_map(const nav_msgs::OccupancyGrid& message);
  void take_update(const map_msgs::OccupancyGridUpdate& message);
  wend::Expected<OccupancyMap::Change, wend::Error> take(const nav_msgs::OccupancyGrid& message);
  std::optional<Change> put(const nav_msgs::OccupancyGrid& message);
  std::optional<Change> put(const map_msgs::OccupancyGridUpdate& message);
  std::optional<Change> put_whole(wend::GridMap map, TimePoint came);
  std::optional<Change> edit(const wend::MapEdit& edit, TimePoint came);

  wend::Session& session_;
  std::function<void(const Change&)> changed_;
  bool costmap_;
  int occupied_from_;
  std::string topic_;

  mutable std::mutex mutex_;  // guards the rest, and keeps a version and its stamp together
  OccupancyMap map_;          // without masks
  Masks masks_;
  TimePoint change_time_;
  TimePoint heard_;
  bool told_order_ = false;  // that a map was older than updates

  std::vector<ros::Subscriber> subscribers_;  // last: they use the others
};

}  // namespace wend_ros
