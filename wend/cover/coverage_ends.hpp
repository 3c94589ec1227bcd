#pragma once

// The checks of what a coverage is asked for, and where it begins.

#include <optional>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/cover/plan_coverage.hpp"

namespace wend {

/// What is wrong with the numbers and areas of the options; nothing if nothing is.
std::optional<Error> fault_of(const CoverageOptions& options, const FreeSpace& space);

/// The cell of the start, or one of the largest component. Fails if the robot cannot stand there, or cannot drive to the end.
Expected<Cell, Error> first_cell(const CoverageOptions& options, const FreeSpace& space);

/// The point if the robot may stand there at every heading, else the middle of its cell, where it may.
std::optional<Point> standing_place(const std::optional<Point>& point, const FreeSpace& space);

}  // namespace wend
