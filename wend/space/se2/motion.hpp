#pragma once

// Motion: a motion at constant velocity from any pose, as a Segment without its first pose. The pose after a motion
// is computed with sine_and_cosine(), so that it is the same on every platform.

#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {

struct Motion {
  double length = 0;  // cells, of the base point's way; negative in reverse
  double turn = 0;    // radians
  double course = 0;  // radians, how far to the left of the heading the base point starts to move

  friend bool operator==(const Motion&, const Motion&) = default;
};

/// The distance of two points, the same on every platform.
inline double straight_distance(Point a, Point b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// The direction of driving: 1 ahead, -1 in reverse, 0 for a turn in place.
constexpr int gear_of(const Motion& motion) {
  return motion.length > 0 ? 1 : motion.length < 0 ? -1 : 0;
}

/// The angle in [-pi, pi], fast for an angle of some turns.
inline double wrapped_angle(double radians) {
  constexpr double kSome = 64;
  if (!(std::abs(radians) <= kSome)) return std::remainder(radians, 2 * kPi);
  while (radians > kPi) radians -= 2 * kPi;
  while (radians < -kPi) radians += 2 * kPi;
  return radians;
}

/// The length of the chord of an arc that turns by `angle`, divided by that of the arc.
inline double chord_share(double angle) {
  const double half = angle / 2;
  return half == 0 ? 1 : sine_and_cosine(half).sine / half;
}

/// The first part of a motion.
constexpr Motion part_of(const Motion& motion, double share) {
  return {motion.length * share, motion.turn * share, motion.course};
}

/// The pose after a motion; its heading is in [-pi, pi].
inline Pose pose_after(const Pose& from, const Motion& motion) {
  const double chord = motion.length * chord_share(motion.turn);
  const auto [sine, cosine] = sine_and_cosine(from.heading + motion.course + motion.turn / 2);
  return {from.x + chord * cosine, from.y + chord * sine,
          wrapped_angle(from.heading + motion.turn)};
}

inline Segment segment_of(const Pose& from, const Motion& motion) {
  return {from, motion.length, motion.turn, motion.course};
}

}  // namespace wend
