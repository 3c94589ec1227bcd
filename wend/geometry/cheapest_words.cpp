#include "wend/geometry/cheapest_words.hpp"

namespace wend {
namespace {

/// Appends a piece; joins it to the last one if both are parts of one arc or line.
void append(CurvePiece piece, Curve& curve) {
  if (curve.count > 0) {
    CurvePiece& last = curve.pieces[static_cast<std::size_t>(curve.count) - 1];
    if (last.turn == piece.turn && (last.length < 0) == (piece.length < 0)) {
      last.length += piece.length;
      return;
    }
  }
  curve.pieces[static_cast<std::size_t>(curve.count++)] = piece;
}

}  // namespace

RelativePose relative_pose(const Pose& from, const Pose& to, double radius) {
  const SineCosine begin = sine_and_cosine(from.heading);
  const SineCosine end = sine_and_cosine(to.heading);
  const double dx = (to.x - from.x) / radius;
  const double dy = (to.y - from.y) / radius;
  return {begin.cosine * dx + begin.sine * dy,
          begin.cosine * dy - begin.sine * dx,
          whole_turns_removed(to.heading - from.heading),
          {end.sine * begin.cosine - end.cosine * begin.sine,
           end.cosine * begin.cosine + end.sine * begin.sine}};
}

Curve curve_of(const SolvedWord& word, double radius, const CurveCosts& costs) {
  constexpr double kNone = 1e-12;  // the length of a piece that is left out, in radii
  Curve curve;
  for (int i = 0; i < word.shape->count; ++i) {
    const WordPiece& piece = word.shape->pieces[static_cast<std::size_t>(i)];
    const double length = i == 0                         ? word.first
                          : i + 1 == word.shape->count   ? word.last
                          : piece.turn == Turn::straight ? word.line
                                                         : word.arc;
    if (length < kNone) continue;
    const Turn turn =
        word.mirrored ? Turn{static_cast<std::int8_t>(-static_cast<int>(piece.turn))} : piece.turn;
    append({piece.ahead ? length * radius : -length * radius, turn}, curve);
  }
  curve.cost = cost_of(curve.driven(), costs);
  return curve;
}

}  // namespace wend
