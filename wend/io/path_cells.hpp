#pragma once

// What the readers of paths share.

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "wend/map/grid_map.hpp"

namespace wend {

/// A column or row that a map can have is below this.
inline constexpr int kCoordinateEnd = static_cast<int>(GridMap::kMaxCells);

/// "x must be a whole number in 0..1073741823, not '-1'"; `found` is quoted already.
inline std::string wrong_coordinate(std::string_view name, std::string_view found) {
  return fmt::format("{} must be a whole number in 0..{}, not {}", name, kCoordinateEnd - 1, found);
}

}  // namespace wend
