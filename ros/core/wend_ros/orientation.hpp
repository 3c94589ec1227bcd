#pragma once

// Orientation: the heading that a quaternion says, or why it says none. Knows no ROS.
//
//   const auto heading = wend_ros::heading_of({0, 0, 1, 0});  // pi
//   if (!heading) return warn("the pose " + heading.error());

#include <string>

#include "wend/base/expected.hpp"

namespace wend_ros {

/// As in geometry_msgs/Quaternion.
struct Orientation {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 0;
};

/// Is every number 0, as in a message that nobody has filled in?
bool is_unset(const Orientation& turn);

/// How far the length of a quaternion may be from 1; it is normalised then.
inline constexpr double kLengthTolerance = 1e-3;

/// The largest tilt against the vertical, rad: 2.5 degrees.
inline constexpr double kLargestTilt = 0.0436;

/// The heading about +z, in [-pi, pi], or why there is none: "has the orientation (0, 0, 0, 0), whose length is 0,
/// not 1", "has the orientation (0, 0.3827, 0, 0.9239), which is tilted by 45 degrees".
wend::Expected<double, std::string> heading_of(const Orientation& turn);

/// The same for a frame that tf2 has turned: upside down is right too, and a tilt below 45 degrees, as on a ramp. The
/// heading is that of its +x axis, seen from above.
wend::Expected<double, std::string> heading_of_frame(const Orientation& turn);

}  // namespace wend_ros
