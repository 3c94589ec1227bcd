// SPDX-License-Identifier: Apache-2.0
#pragma once

// The heading of an orientation. One that is none, or that is no turn about z, is refused with the reason: what is taken
// for a heading otherwise is a slip of the client. Knows no ROS.
//
//   const auto heading = heading_of({q.x, q.y, q.z, q.w}, Tilt::flat);
//   if (!heading) return refuse("the goal: " + heading.error());

#include <string>

#include "wend/base/expected.hpp"

namespace wend_nav2 {

/// A rotation, of length 1. As geometry_msgs has it, the rotation by nothing is {0, 0, 0, 1}.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

/// How far an orientation may lean from the vertical.
enum class Tilt {
  flat,   // 2.5 degrees: of goals, which somebody typed or clicked
  slope,  // 45 degrees: of robots on ramps, and of paths that begin where they are
};

/// The angle of the turn about z. Fails, with a sentence that begins "its orientation", if a number is not finite, if
/// the length is 0 or the squared length differs from 1 by more than 0.1, as in tf2, and if it leans farther than `tilt`.
wend::Expected<double, std::string> heading_of(const Quaternion& orientation, Tilt tilt);

}  // namespace wend_nav2
