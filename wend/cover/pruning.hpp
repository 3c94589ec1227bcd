#pragma once

// Which strokes a coverage can do without.

#include <cstddef>
#include <vector>

#include "wend/cover/coverage_area.hpp"

namespace wend {

/// Removes strokes of which little is left that no other one covers, those first whose length gains least, as long as at
/// most `may_stay` cells become uncovered. O(cells that the strokes cover).
std::vector<Stroke> pruned(const CoverageArea& area, std::vector<Stroke> strokes,
                           std::size_t may_stay);

}  // namespace wend
