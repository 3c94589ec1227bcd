#pragma once

// Helpers for sweeps of a robot along lines and arcs: which obstacles are near, a word of 64 cells at a
// time; how far the map's edge is; and bounds of a piece of a line or an arc, which is halved until
// the clearance of one cell decides. In grid coordinates.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The cell of the map that is nearest to a point; for NaN the first one.
inline Cell nearest_cell(const FreeSpace& space, Point point) {
  // In this order, std::max() takes 0 for NaN. What is not negative, a conversion rounds down.
  return {static_cast<int>(std::min(std::max(0.0, point.x), space.width() - 1.0)),
          static_cast<int>(std::min(std::max(0.0, point.y), space.height() - 1.0))};
}

/// Does any obstacle satisfy the predicate? Tests all obstacles that reach into the box, row by row, and
/// perhaps others on the map's border.
template <class Predicate>
bool any_obstacle(const FreeSpace& space, const Box& box, Predicate&& predicate) {
  const Cell first = nearest_cell(space, box.low);
  const Cell last = nearest_cell(space, box.high);
  for (int y = first.y; y <= last.y; ++y) {
    const auto words = space.obstacles().blocked().row_words(y);
    const auto begin = static_cast<std::size_t>(first.x) + 1;  // the bit of cell x is x + 1
    const auto end = static_cast<std::size_t>(last.x) + 2;
    for (std::size_t i = begin / 64; 64 * i < end; ++i) {
      std::uint64_t bits = words[i];
      if (64 * i < begin) bits &= ~std::uint64_t{0} << (begin % 64);
      if (64 * i + 64 > end) bits &= ~(~std::uint64_t{0} << (end % 64));
      for (; bits != 0; bits &= bits - 1) {
        const auto x = static_cast<int>(64 * i) + std::countr_zero(bits) - 1;
        if (predicate(Cell{x, y})) return true;
      }
    }
  }
  return false;
}

/// The clearance of a cell's centre in cells as far as a FreeSpace has it at hand: up to the robot's radius and
/// a bit more. What is farther counts as that far. O(1).
inline double near_clearance(const FreeSpace& space, Cell cell) {
  const double radius = space.radius_in_cells();
  constexpr double kHalf =
      0.5;  // the least clearance outside of obstacles; no smaller robot needs more
  if (radius <= kHalf) return space.obstacles().blocked()[cell] ? 0 : kHalf;
  return space.clearance(cell, radius + (space.outline() != nullptr ? 8 : 2));
}

/// Is a disc with this clearance, in cells, far enough from obstacles?
inline bool keeps_distance(const FreeSpace& space, double clearance) {
  return clearance > 0 && space.far_enough(4 * clearance * clearance);
}

/// The least distance from the map's edge, in cells, exact up to rounding; negative if the point, or a
/// part of the way, lies outside the map. O(1).
double distance_inside(const FreeSpace& space, Point point);
double distance_inside(const FreeSpace& space, const Line& line);
double distance_inside(const FreeSpace& space, const Arc& arc);
inline double distance_inside(const FreeSpace& space, const TurnInPlace& turn) {
  return distance_inside(space, turn.from.point());
}
inline double distance_inside(const FreeSpace& space, const Segment& segment) {
  return distance_inside(space, way_of_base(segment));
}

/// The clearance of a way from the map's edge: its distance, 0 outside the map; infinite if the robot's
/// disc may hang over the edge.
template <class Way>
double edge_clearance(const FreeSpace& space, const Way& way) {
  if (space.outside() == OutsidePolicy::free) return std::numeric_limits<double>::infinity();
  return std::max(distance_inside(space, way), 0.0);
}

/// A line, or a piece of an arc of at most half a circle, and bounds of all its points.
struct SweptPiece {
  Point from;
  Point to;
  Point middle;       // of the chord
  double half_chord;  // the disc over the chord contains the piece
  double bulge;       // largest distance from the chord: half_chord * tan(turn / 4), or a bit more

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

  /// An upper bound on the distance of its points from the centre.
  double farthest_from(Point centre) const {
    const double farther_end = std::max(distance(centre, from), distance(centre, to));
    return std::min(distance(centre, middle) + half_chord, farther_end + bulge);
  }
};

inline double length_of(const Line& line) { return line.length(); }
inline double length_of(const Arc& arc) { return std::abs(arc.length); }
inline double length_of(const TurnInPlace& /*turn*/) { return 0; }
inline double length_of(const Segment& segment) { return std::abs(segment.length); }

inline std::array<Line, 2> halves_of(const Line& line) {
  return {{{line.from, line.middle()}, {line.middle(), line.to}}};
}
inline std::array<Arc, 2> halves_of(const Arc& arc) {
  const double half = arc.length / 2;
  return {{{arc.from, half, arc.curvature}, {pose_on(arc, half), half, arc.curvature}}};
}

inline std::array<TurnInPlace, 2> halves_of(const TurnInPlace& turn) {
  const double half = turn.angle / 2;
  return {{{turn.from, half}, {pose_on(turn, half), half}}};
}

/// Does the way turn by more than half a circle?
inline bool turns_far(const Line& /*line*/) { return false; }
inline bool turns_far(const Arc& arc) { return std::abs(arc.turn()) > kPi; }

}  // namespace wend
