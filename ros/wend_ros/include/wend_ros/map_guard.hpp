#pragma once

// MapGuard: PathGuard on the newest map of /map and /map_updates, which come in by a thread of its own.

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/control/route.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/session/session.hpp"
#include "wend_ros/map_feed.hpp"
#include "wend_ros/path_guard.hpp"

namespace wend_ros {

class MapGuard {
 public:
  /// Reads ~robot_radius, ~footprint, ~unknown_free and ~outside, which are the planner's, GuardOptions, and what
  /// MapFeed reads.
  MapGuard(ros::NodeHandle& own, const wend::VelocityLimits& limits, double period);
  ~MapGuard();
  MapGuard(const MapGuard&) = delete;
  MapGuard& operator=(const MapGuard&) = delete;

  /// The map of now, or why there is none.
  wend::Expected<MapFeed::Now, wend::Error> now() const { return feed_->now(); }

  const PathGuard& path() const { return *path_; }

 private:
  wend::Session session_;
  std::unique_ptr<PathGuard> path_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::unique_ptr<MapFeed> feed_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;  // last: it uses the others
};

}  // namespace wend_ros
