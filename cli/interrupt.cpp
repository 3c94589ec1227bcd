#include "cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

// Signal handlers can only reach globals.
std::atomic<bool> came = false;
std::atomic<int> interruptibles = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void on_interrupt(int /*signal*/) {
  const bool first = !came.exchange(true);
  if (!first || interruptibles == 0) _exit(interrupted);
}

}  // namespace

void end_on_interrupt() {
  struct sigaction action{};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
}

Interruptible::Interruptible() { ++interruptibles; }
Interruptible::~Interruptible() { --interruptibles; }
const std::atomic<bool>& Interruptible::cancelled() { return came; }

}  // namespace wend::cli
