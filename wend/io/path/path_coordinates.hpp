#pragma once

// The values in path files, CSV and JSON, and the errors about them.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "wend/geometry/compass.hpp"
#include "wend/io/file_error.hpp"
#include "wend/io/text.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/robot/near_map.hpp"

namespace wend {

/// Columns and rows of a map are below this, and coordinates of points on a map do not exceed it. A path may leave
/// the map on every side, as far.
inline constexpr int kCoordinateEnd = static_cast<int>(kFarthestPoint);

/// "x must be a whole number in -1073741824..1073741823, not '1.5'"; `found` is already quoted.
inline std::string wrong_coordinate(std::string_view name, std::string_view found) {
  return fmt::format("{} must be a whole number in -{}..{}, not {}", name, kCoordinateEnd,
                     kCoordinateEnd - 1, found);
}

/// The same for a pose: "x must be a number in -1073741824..1073741824, not 'nan'".
inline std::string wrong_pose_coordinate(std::string_view name, std::string_view found) {
  return fmt::format("{} must be a number in -{}..{}, not {}", name, kCoordinateEnd, kCoordinateEnd,
                     found);
}

template <class Number>
bool may_be_coordinate_of_cell(Number value) {
  return value >= -kCoordinateEnd && value < kCoordinateEnd;
}

inline bool may_be_coordinate_of_pose(double value) { return std::abs(value) <= kCoordinateEnd; }

/// "heading must be N, W, E, S or radians, not 'Q'"; radians are in -1e6..1e6, kLargestHeading.
inline std::string wrong_heading(std::string_view name, std::string_view found) {
  return fmt::format("{} must be N, W, E, S or radians, not {}", name, found);
}

/// The angle of "N", "W", "E" or "S". Their numbers 0 to 3 are not headings here: a number is an angle.
inline std::optional<double> radians_of_letter(std::string_view letter, bool y_up) {
  for (const Heading heading : kAllHeadings) {
    if (letter == letter_of(heading, {.y_up = y_up})) return radians_of(heading);
  }
  return std::nullopt;
}

inline bool may_be_heading(double radians) { return std::abs(radians) <= kLargestHeading; }

/// A FailedPlan with a plan's status and reason, as far as they are kept.
inline FailedPlan failed_plan(std::string_view status, std::string_view reason) {
  return {printable(status, 40), text_line(reason, 1000)};
}

}  // namespace wend
