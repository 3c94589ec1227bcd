#pragma once

// The six moves of a car that stands on the corners of a grid: the one table that space, pictures,
// command lists and tests read.
//
// A straight move is one unit long. A turn is a quarter circle of radius one: it ends one unit
// ahead (or behind) and one unit to its side, and turns the heading by 90 degrees: ahead to that
// side, in reverse to the other one. So reversing to the right undoes a forward right turn.
//
//   const wend::CornerPose from{{1, 0}, wend::Heading::east};
//   const wend::CornerPose to = wend::moved(from, wend::CarMove::fwd_right, /*y_up=*/false);
//   // to is (2,1) facing south

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/heading.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

/// In the order in which successors are generated; the numbers are those of the ROS messages.
enum class CarMove : std::uint8_t { fwd, fwd_right, fwd_left, rev, rev_right, rev_left };

struct CarMoveInfo {
  std::string_view name;
  int gear;  // 1 ahead, -1 in reverse
  int side;  // 1 to the right, -1 to the left, 0 straight
};

inline constexpr int kCarMoves = 6;
inline constexpr std::array<CarMoveInfo, kCarMoves> kCarMoveTable{{{"FWD", 1, 0},
                                                                   {"FWD_RIGHT", 1, 1},
                                                                   {"FWD_LEFT", 1, -1},
                                                                   {"REV", -1, 0},
                                                                   {"REV_RIGHT", -1, 1},
                                                                   {"REV_LEFT", -1, -1}}};

constexpr const CarMoveInfo& info_of(CarMove move) {
  return kCarMoveTable[static_cast<std::size_t>(move)];
}

constexpr std::string_view to_string(CarMove move) { return info_of(move).name; }
constexpr bool is_turn(CarMove move) { return info_of(move).side != 0; }
constexpr bool is_reverse(CarMove move) { return info_of(move).gear < 0; }

/// In units: 1 or pi / 2.
constexpr double length_of(CarMove move) { return is_turn(move) ? kPi / 2 : 1; }

/// The move that leads back.
constexpr CarMove inverse(CarMove move) {
  return static_cast<CarMove>((static_cast<unsigned>(move) + kCarMoves / 2) % kCarMoves);
}

/// The move of that name, FWD_RIGHT say; nothing for any other text.
std::optional<CarMove> car_move_from_string(std::string_view name);

/// Where a car stands: on a corner (the point with these grid coordinates), facing a heading.
struct CornerPose {
  Cell corner;
  Heading heading = Heading::east;

  friend constexpr bool operator==(const CornerPose&, const CornerPose&) = default;
};

/// After a move on a lattice whose unit is so many cells.
constexpr CornerPose moved(const CornerPose& from, CarMove move, bool y_up, int unit = 1) {
  const CarMoveInfo& info = info_of(move);
  const Cell along = ahead(from.heading, y_up);
  const Cell right = ahead(right_of(from.heading), y_up);
  const Cell corner{from.corner.x + unit * (info.gear * along.x + info.side * right.x),
                    from.corner.y + unit * (info.gear * along.y + info.side * right.y)};
  if (info.side == 0) return {corner, from.heading};
  return {corner, info.gear == info.side ? right_of(from.heading) : left_of(from.heading)};
}

/// The same as a pose in grid coordinates.
inline Pose pose_of(const CornerPose& place, bool y_up) {
  return {static_cast<double>(place.corner.x), static_cast<double>(place.corner.y),
          radians_of(place.heading, y_up)};
}

/// The corner of the lattice and the heading nearest to a pose in grid coordinates, all finite. It
/// may lie outside any map; nothing where its numbers are too large for a corner.
std::optional<CornerPose> nearest_corner_pose(const Pose& pose, bool y_up, int unit = 1);

}  // namespace wend
