#include "wend/geometry/segment.hpp"

#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

template <class PoseType>
BasicArc<PoseType> arc_of_base(const BasicSegment<PoseType>& segment) {
  const PoseType& from = segment.from;
  const double curvature = segment.length == 0 ? 0 : segment.turn / segment.length;
  return {{from.x, from.y, from.heading + segment.course}, segment.length, curvature};
}

template <class PoseType>
PoseType pose_after_share(const BasicSegment<PoseType>& segment, double share) {
  const auto point = point_on(arc_of_base(segment), segment.length * share);
  return {point.x, point.y, normalized_angle(segment.from.heading + segment.turn * share)};
}

}  // namespace

Segment segment_between(const Pose& from, const Pose& to) {
  const double turn = normalized_angle(to.heading - from.heading);
  const double chord = distance(from.point(), to.point());
  constexpr double kNoWay = 1e-10;
  if (chord < kNoWay) return {from, 0, turn, 0};
  // The chord leads in the direction that the base point has half-way.
  const double direction = arc_tangent(to.y - from.y, to.x - from.x);
  double course = normalized_angle(direction - from.heading - turn / 2);
  const double half = turn / 2;
  double length = half == 0 ? chord : chord * half / sine_and_cosine(half).sine;
  constexpr double kRounding = 1e-9;
  if (std::abs(course) > kPi / 2 + kRounding) {
    length = -length;
    course = normalized_angle(course - kPi);
  }
  if (std::abs(course) < kRounding) course = 0;
  return {from, length, turn, course};
}

Arc way_of_base(const Segment& segment) { return arc_of_base(segment); }
MapArc way_of_base(const MapSegment& segment) { return arc_of_base(segment); }

Pose pose_on(const Segment& segment, double share) { return pose_after_share(segment, share); }
MapPose pose_on(const MapSegment& segment, double share) {
  return pose_after_share(segment, share);
}

Segment beginning_of(const Segment& segment, double share) {
  return {segment.from, segment.length * share, segment.turn * share, segment.course};
}

std::array<Segment, 2> halves_of(const Segment& segment) {
  const Segment first = beginning_of(segment, 0.5);
  return {first, {end_of(first), first.length, first.turn, first.course}};
}

}  // namespace wend
