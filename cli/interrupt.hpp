#pragma once

// Ctrl-C asks the search to stop; a second one ends the program.

#include <atomic>

namespace wend::cli {

/// From now on Ctrl-C sets the flag that this returns.
const std::atomic<bool>& cancel_on_interrupt();

}  // namespace wend::cli
