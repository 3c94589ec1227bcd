#pragma once

// Stepper: --step. Shows a search after an expansion and asks where to go from there.

#include <cstdint>
#include <optional>
#include <string>

#include "cli/interrupt.hpp"
#include "cli/watching/console.hpp"

namespace wend::cli {

class Stepper {
 public:
  /// In place: each picture takes the place of the one before.
  explicit Stepper(bool in_place) : display_(in_place) {}

  /// The help on keys that stands below every picture, folded to `columns`.
  static std::string keys(int columns);

  /// Shows the picture after `expansions` and waits for a key. The number of expansions to show next;
  /// nothing if the user quits or presses Ctrl-C.
  std::optional<std::uint64_t> ask(const std::string& picture, std::uint64_t expansions);

  /// Makes room for the outcome.
  void finish() { display_.clear(); }

  /// Does the last picture stand where the outcome will be shown?
  bool in_place() const { return display_.in_place(); }

 private:
  Interruptible interruptible_;  // to restore the cursor and the keyboard
  Display display_;
  Keyboard keyboard_;
};

}  // namespace wend::cli
