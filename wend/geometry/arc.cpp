#include "wend/geometry/arc.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

template <class PoseType>
auto point_after(const BasicArc<PoseType>& arc, double length) -> decltype(arc.from.point()) {
  const PoseType& from = arc.from;
  // The chord has the length of the arc times sin(turn / 2) / (turn / 2), rotated by half the turn.
  const double half = length * arc.curvature / 2;
  const double shrink = half == 0 ? 1 : std::sin(half) / half;
  const double chord = length * shrink;
  return {from.x + chord * std::cos(from.heading + half),
          from.y + chord * std::sin(from.heading + half)};
}

template <class PoseType>
PoseType pose_after(const BasicArc<PoseType>& arc, double length) {
  const auto point = point_after(arc, length);
  return {point.x, point.y, normalized_angle(arc.from.heading + length * arc.curvature)};
}

}  // namespace

Arc arc_to(const Pose& from, Point to) {
  const double cosine = std::cos(from.heading);
  const double sine = std::sin(from.heading);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double along = cosine * dx + sine * dy;
  const double across = cosine * dy - sine * dx;
  const double squared = dx * dx + dy * dy;
  // A point this near the line counts as on it: the circle through it would be useless.
  constexpr double kStraight = 1e-12;
  if (std::abs(across) <= kStraight * std::sqrt(squared)) return {from, along, 0};
  const double curvature = 2 * across / squared;
  const double turn = 2 * std::atan2(across, std::abs(along)) * (along < 0 ? -1 : 1);
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
  return std::max(1, static_cast<int>(std::ceil(std::abs(arc.turn()) / (2 * std::acos(cosine)))));
}

}  // namespace wend
