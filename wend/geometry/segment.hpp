#pragma once

// Segment: a motion at constant velocity in the robot's own frame: ahead or back, to a side, and turning.
// It joins any two poses: an arc that a car drives, a turn in place, a step to the side.
//
//   const wend::Segment aside = wend::segment_between({0, 0, 0}, {0, 2, 0});   // 2 to the left
//   const wend::Segment turn = wend::segment_between({0, 0, 0}, {0, 0, 1.5});  // in place
//   const wend::Pose middle = wend::pose_on(turn, 0.5);                        // heading 0.75
//
// Such motions are the one-parameter subgroups of the plane's rigid motions: K. Lynch and F. Park, "Modern
// Robotics", 2017, section 3.2.

#include <array>

#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// A motion at constant velocity. Its pose and its length are in the same coordinates, grid or map.
struct Segment {
  Pose from;          // where the segment begins
  double length = 0;  // of the base point's way, an arc; negative in reverse
  double turn = 0;    // radians, of the heading and of the base point's direction
  double course = 0;  // radians, how far to the left of the heading the base point starts to move;
                      // in [-pi/2, pi/2]

  /// A segment of length 0 at the origin.
  Segment() = default;
  /// Sets `from`, `length`, `turn` and `course`.
  Segment(const Pose& first, double way, double angle, double aside)
      : from(first), length(way), turn(angle), course(aside) {}
};

/// The shortest segment that turns the shorter way: by (-pi, pi].
WEND_API Segment segment_between(const Pose& from, const Pose& to);

/// The way of the base point: its heading is the direction of travel, which is not the robot's where the
/// segment has a course. Of length 0 for a turn in place.
WEND_API Arc way_of_base(const Segment& segment);

/// The pose after a share of the segment, from 0 to 1; headings are in (-pi, pi].
WEND_API Pose pose_on(const Segment& segment, double share);

/// The pose after the whole segment.
inline Pose end_of(const Segment& segment) { return pose_on(segment, 1); }

/// The part of a segment before a share of it.
WEND_API Segment beginning_of(const Segment& segment, double share);

/// The parts before and after the middle.
WEND_API std::array<Segment, 2> halves_of(const Segment& segment);

}  // namespace wend
