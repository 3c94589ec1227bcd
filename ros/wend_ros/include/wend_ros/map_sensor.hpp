#pragma once

// MapSensor: what a simulated robot tells of the map that it discovers: /map, what it knows, and
// /map_updates, what it has just seen; the map that it drives on is /true_map.

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <string>

#include "wend/base/expected.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend_ros/sensed_map.hpp"

namespace wend_ros {

/// The maps of ~map and ~known, files; nothing is known at first without the second. Or what is wrong with them.
wend::Expected<SensedMap, std::string> sensed_map_of(const ros::NodeHandle& own);

class MapSensor {
 public:
  /// Sees `range` metres far.
  MapSensor(ros::NodeHandle& node, SensedMap map, double range);
  MapSensor(const MapSensor&) = delete;
  MapSensor& operator=(const MapSensor&) = delete;

  /// Looks around, and publishes what is new.
  void look(const wend::MapPose& robot);

 private:
  nav_msgs::OccupancyGrid known() const;

  SensedMap map_;
  double range_;
  ros::Publisher truths_;
  ros::Publisher maps_;
  ros::Publisher updates_;
};

}  // namespace wend_ros
