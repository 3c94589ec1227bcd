#pragma once

// NoPath: why no path joins two cells, as data: the sizes of the two components, the largest robot
// that would fit, and the changes that would open a path.
//
// Three changes are possible on the same map: unknown cells count as free, the robot squeezes
// diagonally between two obstacles (8 neighbours, corner rule `both`), or the robot is smaller.
// More neighbours alone and the corner rule `one` never open a new path: two straight steps replace
// a diagonal step with a passable cell beside it.
//
//   const wend::NoPath why = wend::explain_no_path(space, start, goal);
//   for (const wend::Way& way : why.ways) suggest(way);

#include <cstddef>
#include <optional>
#include <vector>

#include "wend/analysis/widest_path.hpp"
#include "wend/base/compiler.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// A set of changes.
struct Changes {
  bool unknown_free = false;  // unknown cells count as free
  bool squeeze = false;  // diagonal steps between two obstacles, as with the corner rule `both`
  bool smaller_robot = false;  // the radius is smaller

  /// Is every change of `other` one of these?
  bool contain(const Changes& other) const {
    return unknown_free >= other.unknown_free && squeeze >= other.squeeze &&
           smaller_robot >= other.smaller_robot;
  }
};

/// A minimal set of changes that opens a path: no proper subset of them does.
struct Way : Changes {
  /// The number of changes, from 0 to 3.
  int changes() const { return int{unknown_free} + int{squeeze} + int{smaller_robot}; }

  /// Under these changes, for a robot of any size. Its radius is smaller than the robot's if
  /// smaller_robot is set, else at least as large.
  WidestPath widest;
};

struct NoPath {
  /// The number of cells that can be reached from each (see component_of), including itself; 0 if
  /// the robot cannot stand there.
  std::size_t start_component = 0;
  std::size_t goal_component = 0;  // the same for the goal

  /// For a robot of any size, without other changes.
  std::optional<WidestPath> widest;

  /// Is there a path after all?
  bool path_exists() const {
    return start_component > 0 && !ways.empty() && ways.front().changes() == 0;
  }

  /// Fewest changes first. Empty if no change helps: an obstacle is on the start or goal, or
  /// walls surround one of them. If there is a path after all: one way, without any change.
  std::vector<Way> ways;
};

/// The cells that the robot can reach from a cell, including itself; none if it cannot stand there, as off the
/// map. Exact like the planners. ConnectedComponents can count too much: a disc does not
/// fit between all corners that a point fits through. O(cells); O(cells log cells) for a disc under
/// the corner rule `both`.
WEND_API BitGrid component_of(const FreeSpace& space, Cell cell, GridMoves moves = {});

/// The number of cells of component_of(). O(1) but for a disc under the corner rule `both`.
WEND_API std::size_t component_size(const FreeSpace& space, Cell cell, GridMoves moves = {});

/// Both cells may be blocked. Empty, without any way, if one is not on the map. O(cells log cells).
WEND_API NoPath explain_no_path(const FreeSpace& space, Cell start, Cell goal,
                                GridMoves moves = {});

/// The same before a deadline; else nothing. It does not begin if the time left is too short for the map.
WEND_API std::optional<NoPath> explain_no_path(const FreeSpace& space, Cell start, Cell goal,
                                               GridMoves moves, const Deadline& deadline);

}  // namespace wend
