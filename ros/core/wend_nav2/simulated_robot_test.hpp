// SPDX-License-Identifier: Apache-2.0
#pragma once

// A robot that does as it is told, and a check of where it has been that shares no code with what it checks.

#include <algorithm>
#include <cmath>
#include <vector>

#include "wend/control/motion_model.hpp"
#include "wend_nav2/costmaps_test.hpp"

namespace wend_nav2::test {

/// Does a disc come closer than its radius to a lethal cell, or its middle leave the costmap? A hundredth of a
/// millimetre does not count.
inline bool collides(const Costmap& map, const wend::MapPose& pose, double radius) {
  const double size = map.layout.resolution;
  if (pose.x < 0 || pose.y < 0 || pose.x > map.layout.width * size ||
      pose.y > map.layout.height * size) {
    return true;
  }
  for (int y = 0; y < map.layout.height; ++y) {
    for (int x = 0; x < map.layout.width; ++x) {
      if (map.at(x, y) != 254) continue;
      const double dx = std::max({x * size - pose.x, pose.x - (x + 1) * size, 0.0});
      const double dy = std::max({y * size - pose.y, pose.y - (y + 1) * size, 0.0});
      if (std::hypot(dx, dy) < radius - 1e-5) return true;
    }
  }
  return false;
}

/// A robot with a disc.
struct SimulatedRobot {
  wend::MotionModel model = {};
  wend::RobotState state = {};
  double radius = 0.1;

  /// Holds a velocity. False if it collides on the way.
  bool hold(const Costmap& map, const wend::Velocity& velocity, double seconds) {
    constexpr int kSamples = 10;
    bool free = true;
    for (int i = 1; i <= kSamples; ++i) {
      const auto at = wend::hold(state.pose, velocity, seconds * i / kSamples).to.pose;
      free = free && !collides(map, at, radius);
    }
    state = wend::hold(state.pose, velocity, seconds).to;
    return free;
  }
};

}  // namespace wend_nav2::test
