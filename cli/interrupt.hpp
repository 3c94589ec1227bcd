#pragma once

// Ctrl-C ends the program at once, with exit code 130. Code that must first restore something (a
// terminal, a database) or report what it has done makes an Interruptible.
//
// No file is left half-written either way: see write_file().

#include <atomic>
#include <exception>

namespace wend::cli {

/// From now on Ctrl-C ends the program, even if it was started with Ctrl-C ignored.
void end_on_interrupt();

/// While one exists, the first Ctrl-C sets a flag, which its owner checks every few milliseconds. A
/// second one ends the program.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Was Ctrl-C pressed? Then the program ends with ExitCode::interrupted, whatever it still found.
  static const std::atomic<bool>& cancelled();
};

/// Ctrl-C as an exception, for code that cannot end otherwise.
class Cancelled : public std::exception {};

}  // namespace wend::cli
