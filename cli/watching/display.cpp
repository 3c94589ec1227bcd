#include "cli/watching/display.hpp"

#include <cstdio>

#include "cli/output/output.hpp"

namespace wend::cli {
namespace {

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
