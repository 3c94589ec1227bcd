#pragma once

// The free cells that a taut path passes, each a neighbour of the one before: for a robot that cannot follow the
// path itself, because it has to keep away from walls.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/sight/portals.hpp"

namespace wend {

/// Replaces `cells` by those that a path passes from the centre of one cell by corners to the centre of another,
/// both included. A step is diagonal only through a gap. False if there is no such path, as a forged index may say; what
/// was written is of no use then. O(cells passed).
bool write_trail(const Portals& portals, Cell start, std::span<const std::uint32_t> corners,
                 Cell goal, std::vector<Cell>& cells);

}  // namespace wend
