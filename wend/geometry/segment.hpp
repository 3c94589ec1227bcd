#pragma once

// Segment: a motion at constant velocity in the robot's own frame: ahead or back, to a side, and turning.
// It joins any two poses: an arc that a car drives, a turn in place, a step to the side.
//
//   const wend::Segment aside = wend::segment_between({0, 0, 0}, {0, 2, 0});   // 2 to the left
//   const wend::Segment turn = wend::segment_between({0, 0, 0}, {0, 0, 1.5});  // in place
//   const wend::Pose middle = wend::pose_on(turn, 0.5);                        // heading 0.75
//
// A Segment is in grid coordinates, a MapSegment in metres.
//
// Such motions are the one-parameter subgroups of the plane's rigid motions: K. Lynch and F. Park, "Modern
// Robotics", 2017, section 3.2.

#include <array>

#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// A motion at constant velocity. Its length is in the unit of its pose.
template <class PoseType>
struct BasicSegment {
  PoseType from;      // where the segment begins
  double length = 0;  // of the base point's way, an arc; negative in reverse
  double turn = 0;    // radians, of the heading and of the base point's direction
  double course = 0;  // radians, how far to the left of the heading the base point starts to move;
                      // in [-pi/2, pi/2]

  /// A segment of length 0 at the origin.
  BasicSegment() = default;
  /// Sets `from`, `length`, `turn` and `course`.
  BasicSegment(const PoseType& first, double way, double angle, double aside)
      : from(first), length(way), turn(angle), course(aside) {}
};

/// A segment in grid coordinates.
using Segment = BasicSegment<Pose>;
/// A segment in metres.
using MapSegment = BasicSegment<MapPose>;

/// The shortest segment that turns the shorter way: by (-pi, pi].
WEND_API Segment segment_between(const Pose& from, const Pose& to);

/// The way of the base point: its heading is the direction of travel, which is not the robot's where the
/// segment has a course. Of length 0 for a turn in place.
WEND_API Arc way_of_base(const Segment& segment);
/// The same in metres.
WEND_API MapArc way_of_base(const MapSegment& segment);

/// The pose after a share of the segment, from 0 to 1; headings are in (-pi, pi].
WEND_API Pose pose_on(const Segment& segment, double share);
/// The same in metres.
WEND_API MapPose pose_on(const MapSegment& segment, double share);

/// The pose after the whole segment.
inline Pose end_of(const Segment& segment) { return pose_on(segment, 1); }
/// The same in metres.
inline MapPose end_of(const MapSegment& segment) { return pose_on(segment, 1); }

/// The part of a segment before a share of it.
WEND_API Segment beginning_of(const Segment& segment, double share);

/// The parts before and after the middle.
WEND_API std::array<Segment, 2> halves_of(const Segment& segment);

}  // namespace wend
