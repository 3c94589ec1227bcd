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

namespace wend {

enum class TerminalGraphics { ascii, half_blocks, sixel, kitty };
enum class TerminalColours { none, sixteen, palette_256, true_colour };

struct Terminal {
  TerminalGraphics graphics = TerminalGraphics::ascii;
  TerminalColours colours = TerminalColours::none;
  int cell_width = 10;   // pixels a column, for sixel and kitty
  int cell_height = 20;  // pixels a row
  bool unicode = true;   // it has characters beyond ASCII
};

/// What the environment ("NAME=value", then a null pointer) tells about the terminal. ASCII without
/// colours if NO_COLOR is set and not empty, or TERM is missing or "dumb"; then text beside the
/// pictures had better be ASCII too. Whether the output is a terminal at all is the caller's to
/// know.
Terminal detect_terminal(const char* const* environment);

/// The whole map in at most that many columns and rows, in proportion, '\n' after every row. Paths
/// and marks are drawn after scaling and so stay visible however large the map is.
std::string terminal_picture(const Scene& scene, int columns, int rows, const Terminal& terminal,
                             const Style& style = {});

/// A note for below the picture if too many cells share a pixel to show the map, with what would help;
/// else empty.
std::string terminal_shortage(const Scene& scene, int columns, int rows, const Terminal& terminal);

/// The style as terminal_picture() draws the scene in it: with sixteen colours the marks take the
/// pure ones, or they would all come out as one.
Style suited(const Scene& scene, const Style& style, TerminalColours colours);

/// Lines for below that picture: what its colours mean, with the heatmap's title, its least and its
/// greatest value; in ASCII, what its characters mean. No longer than `columns`, unless one entry
/// is. Empty where there is nothing to explain.
std::string terminal_legend(const Scene& scene, int columns, const Terminal& terminal,
                            const Style& style = {});

}  // namespace wend
