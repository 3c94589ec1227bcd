#pragma once

// Stepper: --step. Shows a search after an expansion and asks where to go from there.

#include <cstdint>
#include <optional>
#include <string>

#include "display.hpp"
#include "interrupt.hpp"
#include "keyboard.hpp"

namespace wend::cli {

class Stepper {
 public:
  /// In place: each picture takes the place of the one before.
  explicit Stepper(bool in_place) : display_(in_place) {}

  /// What the keys do: lines that belong below every picture, fitted into so many columns.
  static std::string keys(int columns);

  /// Shows how the search stands after so many expansions and waits for a key: after how many to
  /// show it next. Nothing if the person wants to stop, or has pressed Ctrl-C.
  std::optional<std::uint64_t> ask(const std::string& picture, std::uint64_t expansions);

  /// Makes room for the outcome.
  void finish() { display_.clear(); }

  /// Does the last picture stand where the outcome will be shown?
  bool in_place() const { return display_.in_place(); }

 private:
  Interruptible interruptible_;  // the cursor and the keyboard are to be put in order
  Display display_;
  Keyboard keyboard_;
};

}  // namespace wend::cli
