#pragma once

// Keyboard: single keys from standard input, without waiting for a line where that is a terminal.

#include <termios.h>

#include <optional>

#include "cli/interrupt.hpp"

namespace wend::cli {

/// What a key stands for; keys that terminals send as several characters are one.
enum class Key {
  character,  // any that is not named here
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  backspace,
};

struct KeyPress {
  Key key = Key::character;
  char character = 0;
};

class Keyboard {
 public:
  /// From now on keys come at once and are not echoed.
  Keyboard();
  /// As it was before.
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Waits for a key; nothing at the end of the input and after Ctrl-C.
  std::optional<KeyPress> read() const;

 private:
  Interruptible interruptible_;
  std::optional<termios> before_;  // where it is a terminal
};

}  // namespace wend::cli
