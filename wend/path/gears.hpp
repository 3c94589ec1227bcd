#pragma once

// In which gear a robot drives along a path.
//
//   const std::vector<int> gears = wend::gears_of(plan->path);
//   const bool reverses = std::ranges::count(gears, -1) > 0;

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// 1 ahead, -1 in reverse, 0 for a turn in place. A step to a side is ahead.
constexpr int gear_of(const Segment& segment) {
  return segment.length > 0 ? 1 : segment.length < 0 ? -1 : 0;
}

/// The gears of the pieces between a path's poses, one fewer than poses: of cells and waypoints all 1, or 0 where two
/// are the same. Empty for an empty path. O(n).
WEND_API std::vector<int> gears_of(const Path& path);

}  // namespace wend
