#pragma once

// Arc: a curve of constant curvature, as a car drives with constant steering: a circular arc, or a
// line segment if the curvature is 0. It is driven forwards or in reverse.
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // a quarter circle of radius 1
//   const wend::Pose middle = wend::pose_on(arc, arc.length / 2);
//
// An Arc is in grid coordinates, a MapArc in metres.

#include "wend/base/compiler.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// A curve of constant curvature. Its length is in the unit of its pose.
template <class PoseType>
struct BasicArc {
  PoseType from;         // where the arc begins
  double length = 0;     // negative in reverse
  double curvature = 0;  // 1 / radius; positive where the heading grows while driving ahead

  /// The change of heading, in radians.
  double turn() const { return length * curvature; }
};

/// An arc in grid coordinates.
using Arc = BasicArc<Pose>;
/// An arc in metres.
using MapArc = BasicArc<MapPose>;

/// The arc that leaves a pose along its heading, or in reverse if the point is behind, and ends in
/// the point. For a point beside the pose: a half circle.
WEND_API Arc arc_to(const Pose& from, Point to);

/// The point after driving `length` of an arc, from 0 to arc.length.
WEND_API Point point_on(const Arc& arc, double length);
/// The same in metres.
WEND_API MapPoint point_on(const MapArc& arc, double length);

/// The pose after driving `length` of an arc; its heading is in (-pi, pi].
WEND_API Pose pose_on(const Arc& arc, double length);
/// The same in metres.
WEND_API MapPose pose_on(const MapArc& arc, double length);

/// The pose after driving the whole arc.
inline Pose end_of(const Arc& arc) { return pose_on(arc, arc.length); }
/// The same in metres.
inline MapPose end_of(const MapArc& arc) { return pose_on(arc, arc.length); }

/// The number of chords, at least 1, that keep within `tolerance` (> 0, in the units of the arc) of an arc.
WEND_API int chord_count(const Arc& arc, double tolerance);

/// A rotation from a pose by `angle` radians, counter-clockwise if positive: an arc of radius 0.
struct TurnInPlace {
  Pose from;         // before the rotation
  double angle = 0;  // radians
};

/// The pose after turning by `angle`; the heading is not normalised.
inline Pose pose_on(const TurnInPlace& turn, double angle) {
  return {turn.from.x, turn.from.y, turn.from.heading + angle};
}

/// The pose after the whole turn.
inline Pose end_of(const TurnInPlace& turn) { return pose_on(turn, turn.angle); }

}  // namespace wend
