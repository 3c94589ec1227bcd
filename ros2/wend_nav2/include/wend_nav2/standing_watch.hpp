// SPDX-License-Identifier: Apache-2.0
#pragma once

// StandingWatch: for how long a robot has stood where it is, or only trembled there, whatever path it was given
// meanwhile. Knows no ROS.

#include <optional>

#include "wend/geometry/map_pose.hpp"

namespace wend_nav2 {

class StandingWatch {
 public:
  /// From the next pose on.
  void restart() { place_.reset(); }

  /// Takes a pose, `seconds` after the one before. Returns for how long the robot has been within `way` metres
  /// and `turn` radians of one pose.
  double standing_for(const wend::MapPose& pose, double seconds, double way, double turn);

 private:
  std::optional<wend::MapPose> place_ = {};
  double seconds_ = 0;
};

}  // namespace wend_nav2
