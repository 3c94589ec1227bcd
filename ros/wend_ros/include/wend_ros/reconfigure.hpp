#pragma once

// Reconfigure: Parameters on the wire: read from the parameter server at the start, then changed by
// dynamic_reconfigure's messages. Its own server needs types made at compile time; these are made
// from the planners' schemas at run time.

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/ros.h>

#include <functional>
#include <mutex>

#include "wend_ros/parameters.hpp"

namespace wend_ros {

class Reconfigure {
 public:
  /// `changed` is called after every change, from the thread that made it.
  Reconfigure(ros::NodeHandle& own, std::function<void(const Parameters&)> changed);

  Parameters parameters() const;

 private:
  void read(ros::NodeHandle& own);
  bool set(dynamic_reconfigure::Reconfigure::Request& request,
           dynamic_reconfigure::Reconfigure::Response& response);

  mutable std::mutex mutex_;
  Parameters parameters_;
  std::function<void(const Parameters&)> changed_;
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer server_;
};

}  // namespace wend_ros
