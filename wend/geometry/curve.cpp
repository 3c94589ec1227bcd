#include "wend/geometry/curve.hpp"

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

double curvature_of(Turn turn, double radius) { return static_cast<double>(turn) / radius; }

/// Calls `take` with each part of a curve, as an arc whose heading is normalised.
template <class Take>
void for_each_part(const Curve& curve, Pose from, double radius, Take&& take) {
  constexpr double kMostTurn = kPi / 2 * (1 + 1e-12);
  for (const CurvePiece& piece : curve.driven()) {
    const double turn = piece.turn == Turn::straight ? 0 : std::abs(piece.length) / radius;
    const int parts = turn <= kMostTurn ? 1 : static_cast<int>(turn / kMostTurn) + 1;
    const CurvePiece part{piece.length / parts, piece.turn};
    for (int i = 0; i < parts; ++i) {
      take(Arc{from, part.length, curvature_of(piece.turn, radius)});
      from = end_of(part, from, radius);
      from.heading = normalized_angle(from.heading);
    }
  }
}

}  // namespace

double Curve::length() const {
  double sum = 0;
  for (const CurvePiece& piece : driven()) sum += std::abs(piece.length);
  return sum;
}

int Curve::gear_changes() const {
  int changes = 0;
  for (int i = 1; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if ((pieces[at].length < 0) != (pieces[at - 1].length < 0)) ++changes;
  }
  return changes;
}

double cost_of(std::span<const CurvePiece> pieces, const CurveCosts& costs) {
  double sum = 0;
  double gear = 0;  // the sign of the last piece
  for (const CurvePiece& piece : pieces) {
    if (piece.length == 0) continue;
    const double sign = piece.length < 0 ? -1 : 1;
    if (sign == -gear) sum += costs.gear_change;
    gear = sign;
    sum += std::abs(piece.length) * (sign < 0 ? costs.reverse : 1) *
           (piece.turn == Turn::straight ? 1 : costs.turn);
  }
  return sum;
}

Pose end_of(const CurvePiece& piece, const Pose& from, double radius) {
  // The chord of an arc has the direction of its middle, and the length 2 sin(turn / 2) / curvature.
  const double half = piece.length * curvature_of(piece.turn, radius) / 2;
  const double chord = piece.turn == Turn::straight ? piece.length
                                                    : 2 * radius * static_cast<double>(piece.turn) *
                                                          sine_and_cosine(half).sine;
  const SineCosine direction = sine_and_cosine(from.heading + half);
  return {from.x + chord * direction.cosine, from.y + chord * direction.sine,
          from.heading + 2 * half};
}

Pose end_of(const Curve& curve, const Pose& from, double radius) {
  Pose pose = from;
  for (const CurvePiece& piece : curve.driven()) pose = end_of(piece, pose, radius);
  pose.heading = normalized_angle(pose.heading);
  return pose;
}

void append_arcs(const Curve& curve, const Pose& from, double radius, std::vector<Arc>& arcs) {
  for_each_part(curve, from, radius, [&arcs](const Arc& arc) { arcs.push_back(arc); });
}

void append_poses(const Curve& curve, const Pose& from, double radius, std::vector<Pose>& poses) {
  for_each_part(curve, from, radius, [&](const Arc& arc) {
    const Turn turn = arc.curvature == 0  ? Turn::straight
                      : arc.curvature > 0 ? Turn::left
                                          : Turn::right;
    Pose end = end_of(CurvePiece{arc.length, turn}, arc.from, radius);
    end.heading = normalized_angle(end.heading);
    poses.push_back(end);
  });
}

}  // namespace wend
