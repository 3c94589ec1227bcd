#pragma once

// Stepper: --step. Shows a search after an expansion and asks how to go on.

#include <cstdint>
#include <string>

#include "display.hpp"
#include "keyboard.hpp"

namespace wend::cli {

class Stepper {
 public:
  /// In place: each picture takes the place of the one before.
  explicit Stepper(bool in_place) : display_(in_place) {}

  /// Is somebody to be asked after that many expansions?
  bool asks_after(std::uint64_t expansions) const { return expansions >= next_; }

  /// Shows how the search stands after so many expansions and waits for a key.
  void ask(const std::string& picture, std::uint64_t expansions);

  /// Makes room for the outcome.
  void finish() { display_.clear(); }

  /// Does the last picture stand where the outcome will be shown?
  bool in_place() const { return display_.in_place(); }

  /// Does the person want to stop here, by a key or by Ctrl-C?
  bool quit() const { return quit_ || Interruptible::cancelled(); }

 private:
  Display display_;
  Keyboard keyboard_;
  std::uint64_t next_ = 1;
  bool quit_ = false;
};

}  // namespace wend::cli
