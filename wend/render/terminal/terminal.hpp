#pragma once

// Terminal: what a terminal can show, and the ANSI sequences for colours of our own, as near as the
// terminal has them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

  /// Its pictures are plain ASCII.
  bool plain() const {
    return graphics == TerminalGraphics::ascii || colours == TerminalColours::none;
  }
};

/// What the environment ("NAME=value", then a null pointer) tells about the terminal. ASCII without
/// colours if NO_COLOR is set and not empty, or TERM is missing or "dumb"; then text beside the
/// pictures had better be ASCII too. Whether the output is a terminal at all is the caller's to
/// know.
Terminal detect_terminal(const char* const* environment);

inline constexpr const char* kAnsiReset = "\x1b[0m";

/// How many columns UTF-8 takes: characters, without ANSI sequences.
std::size_t columns_of(std::string_view text);

/// Entries with gaps between them, on lines of at most `columns` columns.
std::string in_lines(const std::vector<std::string>& entries, int columns);

/// Sets the background; empty for terminals without colours.
std::string ansi_background(const Colour& colour, TerminalColours colours);

/// A background, and black or white on it, whichever is better to read; empty for terminals that
/// have neither true colour nor 256 colours.
std::string ansi_tile(const Colour& colour, TerminalColours colours);

}  // namespace wend
