#include "cli/watching/console.hpp"

#include <poll.h>
#include <unistd.h>
#include <array>
#include <csignal>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "cli/output/output.hpp"

namespace wend::cli {
namespace {

constexpr char kEscape = '\x1b';
constexpr timespec kWithinASequence{0, 50'000'000};  // its characters come together

/// Blocks Ctrl-C during its lifetime, except while waiting.
class HeldInterrupts {
 public:
  HeldInterrupts() {
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    pthread_sigmask(SIG_BLOCK, &interrupt, &before_);
  }
  ~HeldInterrupts() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  HeldInterrupts(const HeldInterrupts&) = delete;
  HeldInterrupts& operator=(const HeldInterrupts&) = delete;

  /// Waits for input, without a limit for ever. False after the limit and after Ctrl-C.
  bool wait(const timespec* limit) const {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ppoll(&input, 1, limit, &before_) > 0;
  }

 private:
  sigset_t before_{};
};

std::optional<char> next_character() {
  char character = 0;
  if (::read(STDIN_FILENO, &character, 1) != 1) return std::nullopt;
  return character;
}

/// The rest of a sequence that began with Escape: up to its last character, "[D" or "[5~".
std::string rest_of_sequence(const HeldInterrupts& interrupts) {
  std::string rest;
  while (interrupts.wait(&kWithinASequence)) {
    const auto character = next_character();
    if (!character) break;
    rest += *character;
    const bool introduces = rest.size() == 1 && (*character == '[' || *character == 'O');
    if (!introduces && *character >= '@' && *character <= '~') break;
    if (rest.size() == 1 && !introduces) break;
  }
  return rest;
}

KeyPress key_of_sequence(std::string_view rest) {
  static constexpr std::array<std::pair<std::string_view, Key>, 16> kSequences{
      {{"[D", Key::left},
       {"OD", Key::left},
       {"[C", Key::right},
       {"OC", Key::right},
       {"[A", Key::up},
       {"OA", Key::up},
       {"[B", Key::down},
       {"OB", Key::down},
       {"[5~", Key::page_up},
       {"[6~", Key::page_down},
       {"[H", Key::home},
       {"OH", Key::home},
       {"[1~", Key::home},
       {"[F", Key::end},
       {"OF", Key::end},
       {"[4~", Key::end}}};
  for (const auto& [sequence, key] : kSequences) {
    if (rest == sequence) return {key, 0};
  }
  return {Key::character, kEscape};
}

constexpr const char* kHideCursor = "\x1b[?25l";
constexpr const char* kShowCursor = "\x1b[?25h";
constexpr const char* kClearScreen = "\x1b[2J";
constexpr const char* kHome = "\x1b[H";
constexpr const char* kClearLine = "\x1b[K";   // from the cursor on
constexpr const char* kClearBelow = "\x1b[J";  // from the cursor on

/// Every line clears what an earlier picture left to its right. Clearing the screen would flicker.
std::string over_the_last(const std::string& picture) {
  std::string text = kHome;
  for (const char character : picture) {
    if (character == '\n') text += kClearLine;
    text += character;
  }
  return text + kClearBelow;
}

}  // namespace

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

std::optional<KeyPress> Keyboard::read() const {
  // A Ctrl-C between looking at the flag and waiting would go unnoticed until the next key.
  const HeldInterrupts interrupts;
  if (Interruptible::cancelled() || !interrupts.wait(nullptr)) return std::nullopt;
  const auto character = next_character();
  if (!character) return std::nullopt;
  constexpr char kDelete = '\x7f';
  if (*character == kDelete || *character == '\b') return KeyPress{Key::backspace, 0};
  if (*character == kEscape) return key_of_sequence(rest_of_sequence(interrupts));
  return KeyPress{Key::character, *character};
}

Display::Display(bool in_place) : in_place_(in_place) {
  if (in_place_) print(std::string(kHideCursor) + kClearScreen);
}

Display::~Display() {
  if (in_place_) print(kShowCursor);
  std::fflush(stdout);
}

void Display::show(const std::string& picture) {
  print(in_place_ ? over_the_last(picture) : picture + "\n");
  std::fflush(stdout);
}

void Display::clear() {
  if (in_place_) print(over_the_last(""));
}

}  // namespace wend::cli
