#pragma once

// Is it an arrow (wend/map/direction_map.hpp) that keeps a planner from a goal, and which?

#include <optional>

#include "wend/planner/failure.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The cell of the first arrow that the way with the fewest steps against arrows leads against, from cell to cell;
/// nothing if a way leads along the arrows, or if there is none at all. O(cells).
std::optional<Cell> first_arrow_against(const FreeSpace& space, Cell start, Cell goal);

/// Turns causes that say that there is no path into AgainstArrow where arrows are the reason. Of a query that is
/// unreachable.
void tell_arrows(const FreeSpace& space, Failure& failure);

}  // namespace wend
