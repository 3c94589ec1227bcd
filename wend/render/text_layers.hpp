#pragma once

// What is known of every cell of a small map, as text: a grid of arrows (which way to move) or of
// numbers (costs), as the source file looks. Both are as large as the map.
//
//   → ↓ #        0     1  2.41
//   → G #        1  1.41     -
//
// UTF-8, no colours, '\n' after every row, blanks between the columns. O(cells).

#include <optional>
#include <string>

#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"

namespace wend {

/// Cells without an arrow look as in text_picture(); so do start and goals. Two columns a cell.
std::string text_arrows(const Scene& scene, const Grid<std::optional<Direction>>& arrows);

/// Right-aligned, all with as many decimals as are needed (at most two). "-" where the robot may
/// not be, "∞" where the number is infinite, "." where it is not a number.
std::string text_numbers(const FreeSpace& space, const Grid<double>& numbers);

/// How many columns text_numbers() takes for one cell, the blank before it included.
int columns_a_number(const Grid<double>& numbers);

}  // namespace wend
