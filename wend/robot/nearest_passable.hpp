#pragma once

// The nearest cell where the robot may stand, for a start or goal that is blocked.

#include <functional>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The passable cell whose centre is nearest to the centre of `from` (which may lie outside the
/// map), among those connected to `connected_to` if it is given; ties go to the smaller row, then the
/// smaller column. Nothing if no cell is passable. O(cells examined): it searches growing squares around
/// `from` until no nearer cell is possible.
WEND_API std::optional<Cell> nearest_passable(const FreeSpace& space, Cell from,
                                              std::optional<Cell> connected_to = std::nullopt,
                                              Adjacency adjacency = Adjacency::edges);

/// The same among the cells of a grid that `accepts` accepts; it is asked only about cells of the grid. Not the nearest
/// one if the deadline passes before.
WEND_API std::optional<Cell> nearest_accepted(int width, int height, Cell from,
                                              const std::function<bool(Cell)>& accepts,
                                              DeadlineCheck& stop = DeadlineCheck::never());

}  // namespace wend
