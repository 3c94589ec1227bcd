#pragma once

// Chains of neighbouring cells as strokes with few waypoints.

#include <span>

#include "wend/cover/coverage_area.hpp"

namespace wend {

/// The stroke along the middles of a chain of cells (at least one, each an edge's neighbour of the one before), without
/// those that lie within a little of a free line. O(n log n) lines tested.
Stroke smoothed_chain(const CoverageArea& area, std::span<const Cell> chain);

}  // namespace wend
