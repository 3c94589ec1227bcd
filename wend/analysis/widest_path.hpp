#pragma once

// The widest path between two cells: the path for the largest robot, and its narrowest place. It
// answers "does my robot fit, and if not, which door is too narrow, and by how much?"
//
//   if (const auto widest = wend::widest_path(space, start, goal)) report_width(widest->radius);

#include <cstdint>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// The largest radius with which a robot gets from one cell to another, where it is limited, and a
/// path.
struct WidestPath {
  /// The largest radius, in cells, for which a FreeSpace has a path (in metres: times the
  /// resolution). 0: only a point fits, between two obstacles that touch at a corner. Infinite: no
  /// obstacle limits the radius.
  double radius;

  /// The narrowest place, in grid coordinates: a larger robot from the start is stuck there. Its
  /// distance from the nearest obstacle is the radius. It is on the path, or in the centre of a
  /// cell beside one of its diagonal steps if those cells must be passable.
  Point narrowest;

  /// A path for a robot of that radius that enters as few cells as possible where no larger robot
  /// can stand; of those, a shortest one. Terrain is ignored. Empty if the search ran out of
  /// memory.
  Path path;
};

/// For the obstacles of a FreeSpace and robots of any size: ignores its radius and clearance cost.
/// Nothing if not even a point fits, if a cell is not on the map, or if `check` says that the work must end.
/// O(cells log cells).
WEND_API std::optional<WidestPath> widest_path(const FreeSpace& space, Cell start, Cell goal,
                                               GridMoves moves = {},
                                               DeadlineCheck check = DeadlineCheck());

/// The square of that radius alone, in half-cells and exact, like
/// FreeSpace::squared_half_cell_clearance(). Connectivity and the corner rule `one` make no
/// difference: two straight steps replace a diagonal step with a passable cell beside it.
WEND_API std::optional<std::uint32_t> squared_half_cell_width(
    const FreeSpace& space, Cell start, Cell goal, GridMoves moves = {},
    DeadlineCheck check = DeadlineCheck());

}  // namespace wend
