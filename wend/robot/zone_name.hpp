#pragma once

// What a blocked cell is, in words: an obstacle, or a cell that only a mask blocks.

#include <optional>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// "the keep-out mask 'depot.yaml'", or "a keep-out mask" without a name, if a mask blocks a cell of the map that is
/// free without it.
WEND_API std::optional<std::string> mask_that_blocks(const FreeSpace& space, Cell cell);

}  // namespace wend
