// SPDX-License-Identifier: Apache-2.0
#pragma once

// NodeSettings: what the parameters of the planner node say beside the planner's own, and what is wrong with them. Knows
// no ROS.

#include <cstdint>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/robot/footprint.hpp"

namespace wend_ros {

/// By the names of the parameters.
struct NodeSettings {
  double robot_radius = 0.2;  // m
  std::vector<double> footprint =
      {};                  // x1, y1, x2, y2, ... in metres, in place of the radius; empty: none
  std::string shape = {};  // the same parameter as a text, "rect:0.8x0.5,0.2"; empty: none
  std::int64_t occupied_from = 65;  // 1 to 100
  std::string robot_frame = "base_link";
};

/// The robot of the settings. Fails with invalid_option, and the parameter's name, if the radius is not a length from 0
/// on, the corners are not those of a polygon, `occupied_from` is out of its range, or the frame has no name.
wend::Expected<wend::Footprint, wend::Error> robot_from(const NodeSettings& settings);

}  // namespace wend_ros
