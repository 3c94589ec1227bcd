#pragma once

// The terminal that a person watches: Keyboard reads keys, Display shows one picture after another.

#include <termios.h>
#include <optional>
#include <string>

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
  /// Restores the previous settings.
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Waits for a key; nothing at the end of the input and after Ctrl-C.
  std::optional<KeyPress> read() const;

 private:
  Interruptible interruptible_;
  std::optional<termios> before_;  // where it is a terminal
};

class Display {
 public:
  /// In place: each picture takes the place of the one before.
  explicit Display(bool in_place);
  /// Shows the cursor again and leaves the last picture standing.
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Lines of text, each with its end.
  void show(const std::string& picture);

  /// Removes the last picture if pictures are shown in place.
  void clear();

  bool in_place() const { return in_place_; }

 private:
  bool in_place_;
};

}  // namespace wend::cli
