#include "cli/watching/stepper.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

namespace wend::cli {
namespace {

constexpr std::uint64_t kTheEnd = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kLeap = 10;
constexpr std::array<std::string_view, 6> kKeys{"any key, right: next",   "left, backspace: back",
                                                "t, T: ten on, ten back", "home: to the start",
                                                "r: run to the end",      "q: quit"};

}  // namespace

std::string Stepper::keys(int columns) {
  constexpr std::string_view kGap = "   ";
  std::string text;
  std::size_t used = 0;
  for (const std::string_view key : kKeys) {
    const bool fits = used + kGap.size() + key.size() <= static_cast<std::size_t>(columns);
    if (used > 0) text += fits ? kGap : "\n";
    used = used > 0 && fits ? used + kGap.size() + key.size() : key.size();
    text += key;
  }
  return text + "\n";
}

std::optional<std::uint64_t> Stepper::ask(const std::string& picture, std::uint64_t expansions) {
  display_.show(picture);
  const auto pressed = keyboard_.read();
  if (Interruptible::cancelled()) return std::nullopt;
  if (!pressed) return kTheEnd;  // the input has ended
  const auto back = [expansions](std::uint64_t steps) {
    return expansions - std::min(expansions, steps);
  };
  switch (pressed->key) {
    case Key::left:
    case Key::up:
    case Key::backspace:
      return back(1);
    case Key::page_up:
      return back(kLeap);
    case Key::page_down:
      return expansions + kLeap;
    case Key::home:
      return 0;
    case Key::end:
      return kTheEnd;
    case Key::right:
    case Key::down:
    case Key::character:
      break;
  }
  if (pressed->character == 'q') return std::nullopt;
  if (pressed->character == 'r') return kTheEnd;
  if (pressed->character == 't') return expansions + kLeap;
  if (pressed->character == 'T') return back(kLeap);
  return expansions + 1;
}

}  // namespace wend::cli
