#pragma once

// The values in files of paths, and the errors about them, in CSV and in JSON.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "wend/geometry/compass.hpp"
#include "wend/io/io_error.hpp"
#include "wend/io/text.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// A column or row that a map can have is below this; a point on a map is no farther than this.
inline constexpr int kCoordinateEnd = static_cast<int>(GridMap::kMaxCells);

/// "x must be a whole number in 0..1073741823, not '-1'"; `found` is already quoted.
inline std::string wrong_coordinate(std::string_view name, std::string_view found) {
  return fmt::format("{} must be a whole number in 0..{}, not {}", name, kCoordinateEnd - 1, found);
}

/// The same of a pose: "x must be a number in 0..1073741824, not '-1'".
inline std::string wrong_pose_coordinate(std::string_view name, std::string_view found) {
  return fmt::format("{} must be a number in 0..{}, not {}", name, kCoordinateEnd, found);
}

inline bool may_be_coordinate_of_pose(double value) {
  return value >= 0 && value <= kCoordinateEnd;
}

/// "heading must be N, W, E, S or radians, not 'Q'"
inline std::string wrong_heading(std::string_view name, std::string_view found) {
  return fmt::format("{} must be N, W, E, S or radians, not {}", name, found);
}

/// The angle of "N", "W", "E" or "S". The numbers that people may type for them are angles here.
inline std::optional<double> radians_of_letter(std::string_view letter, bool y_up) {
  for (const Heading heading : kAllHeadings) {
    if (letter == letter_of(heading, {.y_up = y_up})) return radians_of(heading);
  }
  return std::nullopt;
}

/// What is kept of a plan's status and reason.
inline FailedPlan failed_plan(std::string_view status, std::string_view reason) {
  return {printable(status, 40), text_line(reason, 1000)};
}

}  // namespace wend
