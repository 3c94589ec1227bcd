#pragma once

// What is known of every cell of a small map, as text: a grid of a scene's arrows (which way to
// move) or of its heatmap's numbers (costs), as the source file looks.
//
//   → ↓ #        0     1     #
//   → G #        1  1.41     -
//
// UTF-8, '\n' after every row, blanks between the columns. O(cells).
//
// The one rule for what stands in a cell: an obstacle is "#" whatever is known of it; what has an
// arrow or a finite number shows it; a passable cell whose number is infinite (no path leads from
// there) shows "-"; any other is "?", ":" or ".", as in text_picture() but for rough terrain, whose
// digits would be taken for numbers.

#include <string>

#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"
#include "wend/render/terminal/terminal_picture.hpp"

namespace wend {

/// The scene's arrows, with its start, goals and narrowest place over them. Two columns a cell. In
/// colours, arrows lie on the heat of their cells where the scene has a heatmap.
std::string text_arrows(const Scene& scene, TerminalColours colours = TerminalColours::none,
                        const Style& style = {});

/// The numbers of the scene's heatmap, right-aligned, all with as many decimals as are needed (at
/// most two). With 256 colours or more each lies on its colour of heat.
std::string text_numbers(const Scene& scene, TerminalColours colours = TerminalColours::none,
                         const Style& style = {});

/// How many columns text_numbers() takes for one cell, the blank before it included.
int columns_a_number(const Grid<double>& numbers);

}  // namespace wend
