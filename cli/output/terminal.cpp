#include "cli/output/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace wend::cli {

Screen detect_screen() {
  Screen screen;
  screen.is_terminal = isatty(STDOUT_FILENO) != 0;
  if (!screen.is_terminal) return screen;
  screen.terminal = detect_terminal(environ);
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return screen;
  }
  screen.columns = size.ws_col;
  screen.rows = size.ws_row;
  if (size.ws_xpixel > 0 && size.ws_ypixel > 0) {
    screen.terminal.cell_width = size.ws_xpixel / size.ws_col;
    screen.terminal.cell_height = size.ws_ypixel / size.ws_row;
  }
  return screen;
}

bool has_pixels(const Terminal& terminal) {
  return terminal.graphics == TerminalGraphics::kitty ||
         terminal.graphics == TerminalGraphics::sixel;
}

bool progress_is_seen() { return isatty(STDERR_FILENO) != 0; }

}  // namespace wend::cli
