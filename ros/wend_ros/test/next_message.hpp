#pragma once

// What the tests of nodes wait with.

#include <ros/ros.h>

#include <optional>
#include <string>

namespace wend_ros {

inline const ros::Duration kPatience(30);

/// The next message of a topic, the latched one if there is one.
template <class Message>
std::optional<Message> next(const std::string& topic) {
  const auto message = ros::topic::waitForMessage<Message>(topic, kPatience);
  if (!message) return std::nullopt;
  return *message;
}

/// Waits until something holds; false if it does not in time.
template <class Condition>
bool wait_until(const Condition& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience.toSec());
  while (!condition()) {
    if (ros::WallTime::now() > end) return false;
    ros::WallDuration(0.02).sleep();
    ros::spinOnce();
  }
  return true;
}

}  // namespace wend_ros
