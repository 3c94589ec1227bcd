#pragma once

// What the program writes to: a terminal or not, and how large it is.

#include "wend/render/terminal/terminal_picture.hpp"

namespace wend::cli {

struct Screen {
  bool is_terminal = false;
  int columns = 80;  // where it is no terminal, as wide as one mostly is
  int rows = 60;
  Terminal terminal;  // ASCII without colours, if it is none
};

/// Standard output. NO_COLOR is respected.
Screen detect_screen();

/// Does it draw pictures with pixels of their own, over which no text can stand?
bool has_pixels(const Terminal& terminal);

/// Is somebody watching standard error?
bool progress_is_seen();

}  // namespace wend::cli
