#pragma once

// A small map as text, one character a cell, as the source file looks (maps with y up: last row
// first):
//
//   S→↘.#    #  obstacle       S  start     →  path, towards the next cell
//   ..#↓~    ?  unknown        G  goal      !  the narrowest place
//   .?::G    :  too close for the robot     .  free
//   *  expanded     %  the same on rough ground     +  frontier     @  being expanded
//   s  start's component     g  goal's component
//   ~  rough (a multiplier of 2, or one that is no digit), 3 to 9  rough, by that multiplier
//   ○ ● ◆ ◇  lines: planned, smoothed, driven, possible     R  the robot     ✗  a collision
//   N  the nearest free cell
//
// A scene's arrows are shown too, its heatmap is not: text_numbers() shows that.
//
// Where places are corners, the corners that a car stands on have characters too, with the cells
// between them: two rows and two to four columns a cell, the numbers of corners at the sides:
//
//     0   1   2   3   4   5   6
//   0 S→──→──╮·   ·   ·   ·   ·    →     pose        ─╮│  driven ahead
//            ╰╮                    S→    start       ═╗║  driven in reverse
//   1 ·   ·   ↓╔══←═══←══╗·   ·    G     goal         ·  corner
//      ▓▓▓    ╠╝       ░░╚↑        █▟▄   obstacle
//   2 ·   ·   ↓   ▗▄▄▄▖   G   ·    ░▒▓   rough, by a multiplier above 1, 2.2, 4.6
//                 ▐███▌    ▓▓▓
//   3 ·   ·   ·   ▝▀▀▀▘   ·   ·
//
// The arrow beside a start or a goal is its heading. With a spacing of several cells the lattice's cells
// are drawn: blocked if any of their cells is, of their mean terrain.
//
// UTF-8 or ASCII, '\n' after every row. O(cells + length of the path).

#include <limits>
#include <string>

#include "wend/map/grid_map.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"
#include "wend/render/terminal/terminal.hpp"

namespace wend {

struct TextStyle {
  bool colours = false;  // ANSI colours
  bool legend = false;   // one more line: what the characters in the picture mean
  /// A longer legend takes several lines, and the cells of a car's lattice are as wide as fits.
  int columns = std::numeric_limits<int>::max();
  bool ascii = false;  // > v < ^ - | \ / and the like; = is driven in reverse
};

std::string text_picture(const Scene& scene, const TextStyle& style = {});

/// Does the picture, without its legend, fit into that many columns and rows?
bool fits_as_text(const Scene& scene, int columns, int rows);

/// Does the map fit into that many columns and rows, one character a cell?
bool fits_as_text(const GridMap& map, int columns, int rows);

// What is known of every cell of a small map: a grid of a scene's arrows (which way to move) or of
// its heatmap's numbers (costs), with blanks between the columns.
//
//   → ↓ #        0     1     #
//   → G #        1  1.41     -
//
// The one rule for what stands in a cell: an obstacle is "#" whatever is known of it; what has an
// arrow or a finite number shows it; a passable cell whose number is infinite (no path leads from
// there) shows "-"; any other is "?", ":" or ".", as in text_picture() but for rough terrain, whose
// digits would be taken for numbers.

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
