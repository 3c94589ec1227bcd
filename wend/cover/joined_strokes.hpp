#pragma once

// Strokes in order as one path: from the end of each to the beginning of the next the shortest free way.

#include <optional>
#include <span>

#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/cover/coverage_area.hpp"

namespace wend {

/// The waypoints, from the start and to the end if they are given. A stroke to which no free lines lead, by a hair's
/// breadth, is left out. Fails with the status of a search that found no way,
/// or with time_limit or cancelled.
Expected<Stroke, Error> joined(const CoverageArea& area, std::span<const Stroke> strokes,
                               std::optional<Point> start, std::optional<Point> end,
                               const Deadline& deadline);

}  // namespace wend
