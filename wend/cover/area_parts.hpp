#pragma once

// Parts of what is left: rooms, which doors join only by a narrow strip. Each gets swaths of its own angle.

#include <vector>

#include "wend/cover/coverage_area.hpp"

namespace wend {

/// The cells that are left, in parts: what hangs together where it is wider than the tool's reach, and the rest with the
/// nearest part. Every cell is in one part. O(cells).
std::vector<std::vector<Cell>> parts_left(const CoverageArea& area);

}  // namespace wend
