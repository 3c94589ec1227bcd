#pragma once

// The car's six motion primitives between the corners of cells: a built-in set of MotionPrimitives, and
// names for its members. The space, command lists and tests read it.
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

#include <cstdint>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/robot/motion_primitives.hpp"

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

/// The set, for a unit of one cell: its headings are in the order of Heading, and the primitives that
/// leave with each are in the order of CarMove.
WEND_API const MotionPrimitives& car_primitives();

/// The primitive of a move from a heading.
WEND_API const MotionPrimitive& primitive_of(Heading heading, CarMove move);

/// Does the move change the heading?
WEND_API bool is_turn(CarMove move);
/// Does the car drive in reverse?
WEND_API bool is_reverse(CarMove move);

/// The length in units: exactly 1 or pi / 2.
WEND_API double length_of(CarMove move);

/// The move that leads back.
WEND_API CarMove inverse(CarMove move);

/// The pose after a move on a lattice with a resolution of `unit` cells.
WEND_API CornerPose moved(const CornerPose& from, CarMove move, int unit = 1);

/// "FWD", "FWD_RIGHT", "FWD_LEFT", "REV", "REV_RIGHT" or "REV_LEFT", as the map is drawn on a page.
WEND_API std::string_view name_of(CarMove move, const Frame& frame);

}  // namespace wend
