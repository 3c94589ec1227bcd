#include "keyboard.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace wend::cli {

Keyboard::Keyboard() {
  termios now{};
  if (isatty(STDIN_FILENO) == 0 || tcgetattr(STDIN_FILENO, &now) != 0) return;
  before_ = now;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  now.c_cc[VMIN] = 1;
  now.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keyboard::~Keyboard() {
  if (before_) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

std::optional<char> Keyboard::read() const {
  // Reading goes on after a signal; polling does not, so Ctrl-C is noticed.
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (!Interruptible::cancelled()) {
    const int ready = poll(&input, 1, -1);
    if (ready < 0 && errno == EINTR) continue;
    char key = 0;
    if (ready <= 0 || ::read(STDIN_FILENO, &key, 1) != 1) break;
    return key;
  }
  return std::nullopt;
}

}  // namespace wend::cli
