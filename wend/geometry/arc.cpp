#include "wend/geometry/arc.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

template <class PoseType>
auto point_after(const BasicArc<PoseType>& arc, double length) -> decltype(arc.from.point()) {
  const PoseType& from = arc.from;
  // The chord has the length of the arc times sin(turn / 2) / (turn / 2), rotated by half the turn.
  const double half = length * arc.curvature / 2;
  const double shrink = half == 0 ? 1 : sine_and_cosine(half).sine / half;
  const double chord = length * shrink;
  const auto [sine, cosine] = sine_and_cosine(from.heading + half);
  return {from.x + chord * cosine, from.y + chord * sine};
}

template <class PoseType>
PoseType pose_after(const BasicArc<PoseType>& arc, double length) {
  const auto point = point_after(arc, length);
  return {point.x, point.y, normalized_angle(arc.from.heading + length * arc.curvature)};
}

}  // namespace

Arc arc_to(const Pose& from, Point to) {
  const auto [sine, cosine] = sine_and_cosine(from.heading);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double along = cosine * dx + sine * dy;
  const double across = cosine * dy - sine * dx;
  const double squared = dx * dx + dy * dy;
  // A point this near the line counts as on it: the circle through it would be useless.
  constexpr double kStraight = 1e-12;
  constexpr double kNearest = 1e-200;  // squared: there, curvatures are no numbers any more
  if (std::abs(across) <= kStraight * std::sqrt(squared) || squared < kNearest) {
    return {from, along, 0};
  }
  const double curvature = 2 * across / squared;
  const double turn = 2 * arc_tangent(across, std::abs(along)) * (along < 0 ? -1 : 1);
  return {from, turn / curvature, curvature};
}

Point point_on(const Arc& arc, double length) { return point_after(arc, length); }
MapPoint point_on(const MapArc& arc, double length) { return point_after(arc, length); }

Pose pose_on(const Arc& arc, double length) { return pose_after(arc, length); }
MapPose pose_on(const MapArc& arc, double length) { return pose_after(arc, length); }

int chord_count(const Arc& arc, double tolerance) {
  if (arc.curvature == 0) return 1;
  // The sagitta of a chord that turns by t is (1 - cos(t/2)) / curvature.
  const double cosine = std::max(1 - tolerance * std::abs(arc.curvature), 0.0);
  const double half = arc_tangent(std::sqrt(1 - cosine * cosine), cosine);
  const double chords = std::ceil(std::abs(arc.turn()) / (2 * half));
  constexpr double kMost = 1 << 20;
  return chords > 1 ? static_cast<int>(std::min(chords, kMost)) : 1;
}

}  // namespace wend
