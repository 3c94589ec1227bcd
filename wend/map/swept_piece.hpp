#pragma once

// What sweeps do with lines and arcs alike: halve them until the clearance of one cell decides.

#include <algorithm>
#include <array>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/obstacles_near.hpp"

namespace wend {

/// A piece of an arc, of at most half a circle, or a line, and what holds all its points.
struct SweptPiece {
  Point from;
  Point to;
  Point middle;       // of the chord
  double half_chord;  // the disc over the chord holds the piece
  double bulge;       // it is no farther off the chord: half_chord * tan(turn / 4), or a bit more

  explicit SweptPiece(const Line& line)
      : from(line.from),
        to(line.to),
        middle(line.middle()),
        half_chord(line.length() / 2),
        bulge(0) {}

  explicit SweptPiece(const Arc& arc)
      : SweptPiece(Line{arc.from.point(), point_on(arc, arc.length)}) {
    bulge = half_chord * std::abs(arc.turn()) / kPi;
  }

  Box box() const {
    Box ends(from);
    ends.include(to);
    return ends.grown_by(bulge);
  }

  /// No point of it is farther than this from the centre.
  double farthest_from(Point centre) const {
    const double farther_end = std::max(distance(centre, from), distance(centre, to));
    return std::min(distance(centre, middle) + half_chord, farther_end + bulge);
  }
};

inline double length_of(const Line& line) { return line.length(); }
inline double length_of(const Arc& arc) { return std::abs(arc.length); }

inline std::array<Line, 2> halves_of(const Line& line) {
  return {{{line.from, line.middle()}, {line.middle(), line.to}}};
}
inline std::array<Arc, 2> halves_of(const Arc& arc) {
  const double half = arc.length / 2;
  return {{{arc.from, half, arc.curvature}, {pose_on(arc, half), half, arc.curvature}}};
}

/// Is it more than half a circle?
inline bool turns_far(const Line& /*line*/) { return false; }
inline bool turns_far(const Arc& arc) { return std::abs(arc.turn()) > kPi; }

}  // namespace wend
