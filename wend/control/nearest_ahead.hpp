#pragma once

// Where on a line a robot is, that has come so far along it: what a follower and remaining() go by.
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

}  // namespace wend
