#pragma once

// Crumbs: what strips and swaths leave over, in short strokes through the places from which the tool covers most of it.

#include <vector>

#include "wend/cover/coverage_area.hpp"

namespace wend {

/// Strokes for what is left, largest parts first, until at most `may_stay` cells are left. Covers them in the area. O(cells + cells left
/// times cells that the tool covers, squared).
std::vector<Stroke> crumbs(CoverageArea& area, std::size_t may_stay);

}  // namespace wend
