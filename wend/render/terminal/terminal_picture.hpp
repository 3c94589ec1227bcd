#pragma once

// A scene as a picture in the terminal, for maps too large for one character a cell: real pixels
// where the terminal has them (kitty's or sixel graphics), coloured half blocks elsewhere, plain
// ASCII where no colour is wanted.
//
//   wend::Terminal terminal;  // plain ASCII
//   if (is_terminal) terminal = wend::detect_terminal(environ);
//   std::cout << wend::terminal_picture(scene, 80, 24, terminal);
//   std::cout << wend::terminal_legend(scene, 80, terminal);

#include <string>

#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"
#include "wend/render/terminal/terminal.hpp"

namespace wend {

/// The whole map in at most that many columns and rows, in proportion, '\n' after every row. Paths
/// and marks are drawn after scaling and so stay visible however large the map is.
std::string terminal_picture(const Scene& scene, int columns, int rows, const Terminal& terminal,
                             const Style& style = {});

/// A note for below the picture if too many cells share a pixel to show the map, with what would
/// help; else empty.
std::string terminal_shortage(const Scene& scene, int columns, int rows, const Terminal& terminal);

/// The same in plain ASCII: every character stands for a block of cells that is twice as high as
/// wide, as characters are.
///
///   #  an obstacle across half of the block, or more     S  start
///   ?  mostly unknown                                    G  goal
///   :  mostly too close for the robot                    o  path
///   .  free                                              =  driven in reverse
///   ~  mostly rough                                      !  the narrowest place
///   o % & -  planned, smoothed, driven, possible         R  the robot    X  a collision
///   N  the nearest free cell
///   0-9  heat, from the least to the greatest value
///   * + @ s g  some of it has a role: expanded, frontier, being expanded, start's or goal's
///   component
std::string ascii_picture(const Scene& scene, int columns, int rows);

/// Lines for below that picture: what its colours mean, with the heatmap's title, its least and its
/// greatest value; in ASCII, what its characters mean. No longer than `columns`, unless one entry
/// is. Empty where there is nothing to explain.
std::string terminal_legend(const Scene& scene, int columns, const Terminal& terminal,
                            const Style& style = {});

}  // namespace wend
