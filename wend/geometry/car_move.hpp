#pragma once

// The car's six motion primitives between lattice vertices: the only table of them, which the
// space, command lists and tests read.
//
// A straight move is one unit long. A turn is a quarter circle of radius one: it ends one unit
// ahead (or behind) and one unit to its side, and turns the heading by 90 degrees: ahead to that
// side, in reverse to the other one. So reversing to a side undoes the forward turn to that side.
//
// Sides are in grid coordinates: plus is the side that headings grow towards, from +x towards +y.
// compass.hpp says whether users call it right or left.
//
//   const wend::CornerPose from{{1, 0}, wend::Heading::plus_x};
//   const wend::CornerPose to = wend::moved(from, wend::CarMove::fwd_plus);  // (2,1) facing +y

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// The moves, in the order in which successors are generated.
enum class CarMove : std::uint8_t {
  fwd,        // straight ahead
  fwd_plus,   // ahead to the plus side
  fwd_minus,  // ahead to the minus side
  rev,        // straight back
  rev_plus,   // back to the plus side
  rev_minus   // back to the minus side
};

inline constexpr int kCarMoves = 6;  // the number of moves

/// 1 ahead, -1 in reverse.
constexpr int gear_of(CarMove move) { return move < CarMove::rev ? 1 : -1; }

/// 1 to the plus side, -1 to the minus side, 0 straight.
constexpr int side_of(CarMove move) {
  constexpr std::array<int, kCarMoves> kSides{0, 1, -1, 0, 1, -1};
  return kSides[static_cast<std::size_t>(move)];
}

/// Does the move change the heading?
constexpr bool is_turn(CarMove move) { return side_of(move) != 0; }
/// Does the car drive in reverse?
constexpr bool is_reverse(CarMove move) { return gear_of(move) < 0; }

/// The length in units: 1 or pi / 2.
constexpr double length_of(CarMove move) { return is_turn(move) ? kPi / 2 : 1; }

/// The move that leads back.
constexpr CarMove inverse(CarMove move) {
  return static_cast<CarMove>((static_cast<unsigned>(move) + kCarMoves / 2) % kCarMoves);
}

/// The place of a car: a corner (the point with these grid coordinates) and a heading.
struct CornerPose {
  Cell corner;                        // the lattice vertex
  Heading heading = Heading::plus_x;  // where the car faces

  friend constexpr bool operator==(const CornerPose&, const CornerPose&) = default;
};

/// The pose after a move on a lattice with a resolution of `unit` cells.
constexpr CornerPose moved(const CornerPose& from, CarMove move, int unit = 1) {
  const int gear = gear_of(move);
  const int side = side_of(move);
  const Cell along = ahead(from.heading);
  const Heading plus = quarter_turned(from.heading);
  const Cell across = ahead(plus);
  const Cell corner{from.corner.x + unit * (gear * along.x + side * across.x),
                    from.corner.y + unit * (gear * along.y + side * across.y)};
  if (side == 0) return {corner, from.heading};
  return {corner, gear == side ? plus : opposite(plus)};
}

/// Converts to a pose in grid coordinates.
inline Pose pose_of(const CornerPose& place) {
  return {static_cast<double>(place.corner.x), static_cast<double>(place.corner.y),
          radians_of(place.heading)};
}

/// The lattice vertex and the heading nearest to a finite pose in grid coordinates. It may lie outside
/// any map. Nothing if the coordinates are too large for a vertex.
inline std::optional<CornerPose> nearest_corner_pose(const Pose& pose, int unit = 1) {
  const double x = unit * std::round(pose.x / unit);
  const double y = unit * std::round(pose.y / unit);
  constexpr double kMost = std::numeric_limits<int>::max();
  if (!(std::abs(x) <= kMost && std::abs(y) <= kMost) || !std::isfinite(pose.heading)) {
    return std::nullopt;
  }
  return CornerPose{{static_cast<int>(x), static_cast<int>(y)}, nearest_heading(pose.heading)};
}

}  // namespace wend
