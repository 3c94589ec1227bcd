// SPDX-License-Identifier: Apache-2.0
#pragma once

// The length of a list of poses, for tests.

#include <cstddef>
#include <span>

#include "wend/geometry/map_pose.hpp"

namespace wend_nav2::test {

/// The sum of the distances between neighbours, m.
inline double path_length(std::span<const wend::MapPose> poses) {
  double length = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length += distance(poses[i - 1].point(), poses[i].point());
  }
  return length;
}

}  // namespace wend_nav2::test
