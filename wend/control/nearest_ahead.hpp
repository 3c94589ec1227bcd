#pragma once

// The robot's place on a line, given its progress so far, and the rest of its path. The follower
// and remaining() use it.
//
// It is the nearest place, unless the line comes near the robot several times because it crosses
// itself or comes back. Then it is the first of those visits in which the line leads the way the
// robot faces, so that no loop is skipped; if no visit does, the first one. A visit is a stretch of
// the line whose points are no more than `tie` farther from the robot than the nearest point. In a
// corner it is enough if one of the two lines leads that way.
//
//   const wend::Polyline there_and_back({{0, 0}, {9, 0}, {0, 0}});
//   const wend::OnPolyline there = wend::nearest_ahead(there_and_back, {4, 0, 0}, {0, 18, 1});

#include <cstdint>
#include <span>

#include "wend/base/compiler.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// The part of a line to search, in the line's units.
struct Reach {
  double from;  // the robot's progress along the line
  double to;    // the upper limit of its progress
  double tie;   // >= 0
};

/// `gears` says of each line whether it is driven ahead (1) or in reverse (-1), where the robot's
/// back leads; empty: ahead. O(lines in reach).
WEND_API OnPolyline nearest_ahead(const Polyline& line, const Pose& pose, const Reach& reach,
                                  std::span<const std::int8_t> gears = {});
/// The same in metres.
WEND_API OnMapPolyline nearest_ahead(const MapPolyline& line, const MapPose& pose,
                                     const Reach& reach, std::span<const std::int8_t> gears = {});

/// The rest of a path from the robot's place, for plans that are updated while driving.
///
///   const wend::Remaining rest = wend::remaining(path, pose, driven_so_far);
///   driven_so_far = rest.along;
///
/// In grid coordinates. The path continues from its nearest point ahead, never behind `from`. Where
/// the path crosses or meets itself, it is the next strand that leads the way the robot faces, so
/// that no loop is skipped.
struct Remaining {
  Path path;            // waypoints, the nearest point first; for a car, poses
  double along = 0;     // cells of the path that are behind
  double distance = 0;  // cells, from the robot to the path
};

/// The rest of a path (not empty); `from` is the previous Remaining::along. O(n).
WEND_API Remaining remaining(const Path& path, const Pose& pose, double from = 0);

}  // namespace wend
