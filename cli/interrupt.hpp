#pragma once

// Ctrl-C asks the search to stop; a second one ends the program.

#include <atomic>
#include <exception>

namespace wend::cli {

/// From now on Ctrl-C sets the flag that this returns.
const std::atomic<bool>& cancel_on_interrupt();

/// Ctrl-C, thrown out of what cannot end otherwise.
class Cancelled : public std::exception {};

}  // namespace wend::cli
