#pragma once

// Ctrl-C ends the program at once, with exit code 130. What has something to put in order first (a
// terminal, a database) or something to say of what it did until then makes an Interruptible.
//
// No file is left half-written either way: see write_file().

#include <atomic>
#include <exception>

namespace wend::cli {

/// From now on Ctrl-C ends the program; also where it was started with Ctrl-C ignored.
void end_on_interrupt();

/// While there is one, the first Ctrl-C sets a flag, at which whoever made it looks every few
/// milliseconds. A second one ends the program.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Has Ctrl-C come? Then the program ends with ExitCode::interrupted, whatever it still found.
  static const std::atomic<bool>& cancelled();
};

/// Ctrl-C as an exception, for code that cannot end otherwise.
class Cancelled : public std::exception {};

}  // namespace wend::cli
