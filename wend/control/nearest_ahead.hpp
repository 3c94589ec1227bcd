#pragma once

// Where on a line a robot is, that has come so far along it, and what is left of its path: what a
// follower and remaining() go by.
//
// The nearest place, unless the line comes near the robot several times, where it crosses itself or
// comes back: then the first of those visits in which the line leads the way the robot faces, so
// that no loop is skipped; if none does, the first one. A visit is a stretch of the line whose points
// are no more than `tie` farther from the robot than the nearest point. In a corner it is enough if one
// of the two lines leads that way.
//
//   const wend::Polyline there_and_back({{0, 0}, {9, 0}, {0, 0}});
//   const wend::OnPolyline there = wend::nearest_ahead(there_and_back, {4, 0, 0}, {0, 18, 1});

#include <cstdint>
#include <span>

#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// In the line's units.
struct Reach {
  double from;  // the robot has come so far along the line
  double to;    // and no farther than this
  double tie;   // >= 0
};

/// `gears` says of each line whether it is driven ahead (1) or in reverse (-1), where the robot's
/// back leads; empty: ahead. O(lines in reach).
OnPolyline nearest_ahead(const Polyline& line, const Pose& pose, const Reach& reach,
                         std::span<const std::int8_t> gears = {});

/// What is left of a path from where the robot is: for plans that are updated while driving.
///
///   const wend::Remaining rest = wend::remaining(path, pose, driven_so_far);
///   driven_so_far = rest.along;
///
/// In grid coordinates. The path goes on from its nearest point ahead: never back behind `from`, and
/// where it crosses or meets itself, on the strand that comes next and leads the way the robot faces,
/// so that no loop is skipped.
struct Remaining {
  Path path;            // waypoints, the nearest point first; of a car's path its poses
  double along = 0;     // cells of the path that are behind
  double distance = 0;  // cells, from the robot to the path
};

/// Of a path (not empty); `from` is how much of it was behind before. O(n).
Remaining remaining(const Path& path, const Pose& pose, double from = 0);

}  // namespace wend
