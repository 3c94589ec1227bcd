#pragma once

// ANSI sequences for colours of our own, as near as the terminal has them.

#include <string>

#include "wend/render/style.hpp"
#include "wend/render/terminal/terminal_picture.hpp"

namespace wend {

inline constexpr const char* kAnsiReset = "\x1b[0m";

/// Sets the background; empty for terminals without colours.
std::string ansi_background(const Colour& colour, TerminalColours colours);

/// A background, and black or white on it, whichever is better to read; empty for terminals that
/// have neither true colour nor 256 colours.
std::string ansi_tile(const Colour& colour, TerminalColours colours);

}  // namespace wend
