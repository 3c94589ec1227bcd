#pragma once

// Clearance of an arc, a line or a step between cells: the distance from the nearest of its points to
// the nearest closed obstacle square, or to the map's edge if the outside is blocked, exact up to
// rounding; and how much room there is beside it.
//
// Arcs and lines are in grid coordinates; arcs turn by at most 2 pi. They may touch the map's edge or leave
// the map. If the outside is free, it is not an obstacle. Ways that are not near_map() have no clearance.
//
//   const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // from corner to corner of cell (0,0)
//   const double clearance = wend::arc_clearance(space, arc);

#include <cstdint>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/line.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The clearance in cells; 0 if the arc touches an obstacle or is not near_map(), infinite if nothing is near. An arc of
/// length 0 has the clearance of its point. O(cells of a box around the arc as wide as what the
/// clearance of the cells that it passes leaves open).
WEND_API double arc_clearance(const FreeSpace& space, const Arc& arc);

/// The clearance of the straight way between the centres of a cell and one of its eight neighbours (or
/// itself), exact, squared and in half-cells, like FreeSpace::squared_half_cell_clearance(); 0 where a
/// diagonal way touches an obstacle. Both cells are on the map. O(1).
WEND_API std::uint32_t squared_half_cell_way_clearance(const FreeSpace& space, Cell from, Cell to);

/// The same between any two cells, in cells; infinite where nothing is near, 0 if one is not on the map. O(1)
/// for neighbours, else as arc_clearance().
WEND_API double way_clearance(const FreeSpace& space, Cell from, Cell to);

/// The largest room that room_along() reports, in cells.
inline constexpr double kMostRoom = 1;

/// How much room there is beside a line that a robot drives, so that a smoother can move points
/// repeatedly without reading the map. Each end of the line may move by this distance, in cells, in any
/// direction, and the robot can still drive along it. It is the swept clearance beyond the robot's
/// radius (for a polygon, of its circumscribed disc), up to kMostRoom, and 0 where the robot touches. It
/// may be less than that where it is at least half of kMostRoom. Nothing if the line is not free by
/// disc_fits_along(), or ends in a gap between two obstacles (in_gap()), where the lines before and after
/// it decide. O(1) where the clearance of a cell decides, else O(cells within the radius and kMostRoom),
/// for each length.
WEND_API std::optional<double> room_along(const FreeSpace& space, const Line& line,
                                          Adjacency adjacency = Adjacency::edges);

}  // namespace wend
