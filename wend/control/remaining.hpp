#pragma once

// What is left of a path from where the robot is: for plans that are updated while driving.
//
//   const wend::Remaining rest = wend::remaining(path, pose, driven_so_far);
//   driven_so_far = rest.along;
//
// In grid coordinates. The path goes on from its nearest point ahead: never back behind `from`, and
// where it crosses or meets itself, on the strand that comes next and leads the way the robot faces,
// so that no loop is skipped.

#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"

namespace wend {

struct Remaining {
  Path path;            // waypoints, the nearest point first; of a car's path its poses
  double along = 0;     // cells of the path that are behind
  double distance = 0;  // cells, from the robot to the path
};

/// Of a path (not empty); `from` is how much of it was behind before. O(n).
Remaining remaining(const Path& path, const Pose& pose, double from = 0);

}  // namespace wend
