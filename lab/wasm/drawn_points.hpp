#pragma once

// A path as the page draws it: points that lines join.

#include <cstddef>
#include <vector>

#include "wend/path/path.hpp"

namespace wend::lab {

/// Of each point: x, y and heading, in grid coordinates.
inline constexpr std::size_t kNumbersOfPoint = 3;

/// The numbers of all points of a path; an arc becomes some lines.
std::vector<double> drawn_points(const Path& path);

}  // namespace wend::lab
