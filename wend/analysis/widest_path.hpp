#pragma once

// The widest path between two cells: the one that lets the largest robot through, and where it is
// narrowest. For "does my robot fit, and if not, which door is too narrow, and by how much?"
//
//   if (const auto widest = wend::widest_path(space, start, goal)) report_width(widest->radius);

#include <cstdint>
#include <optional>

#include "wend/geometry/pose.hpp"
#include "wend/map/free_space.hpp"
#include "wend/path/path.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

struct WidestPath {
  /// In cells, the largest for which a FreeSpace has a path: it has one for this radius (in metres:
  /// times the resolution) and for none that is larger. 0: only a point gets through, between two
  /// obstacles that touch with their corners. Infinite where no obstacle is in the way of any disc.
  double radius;

  /// In grid coordinates, where a larger robot that comes from the start is stuck: a point as far from the nearest obstacle as
  /// the radius. On the path, or in the centre of a cell beside one of its diagonal steps where
  /// those must be passable.
  Point narrowest;

  /// A path for a robot of that radius which enters as few cells as possible where no larger one
  /// can stand; of those a shortest. The terrain does not matter. Empty if there was no memory for
  /// the search.
  Path path;
};

/// On the obstacles of a FreeSpace, for robots of any size: its own radius and keep-away do not
/// matter. Both cells are on the map. Nothing if not even a point gets through. O(cells log cells).
std::optional<WidestPath> widest_path(const FreeSpace& space, Cell start, Cell goal,
                                      GridMoves moves = {});

/// The square of that radius alone, in half-cells and exact, like
/// FreeSpace::squared_half_cell_clearance(). Connectivity and the corner rule `one` make no
/// difference: around a diagonal step with a passable cell beside it lead two straight ones.
std::optional<std::uint32_t> squared_half_cell_width(const FreeSpace& space, Cell start, Cell goal,
                                                     GridMoves moves = {});

}  // namespace wend
