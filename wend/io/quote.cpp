#include "wend/io/quote.hpp"

#include <fmt/format.h>

#include "wend/io/utf8.hpp"

namespace wend {
namespace {

constexpr std::size_t kLongest = 40;

bool is_printable(char letter) { return letter >= ' ' && letter <= '~'; }
/// Whether a byte is a continuation byte of UTF-8.
bool continues_letter(char letter) { return (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U; }
unsigned byte_of(char letter) { return static_cast<unsigned char>(letter); }

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  for (const char letter : text.substr(0, longest)) {
    shown +=
        is_printable(letter) ? std::string(1, letter) : fmt::format("\\x{:02X}", byte_of(letter));
  }
  return shown;
}

std::string text_line(std::string_view text, std::size_t longest) {
  while (longest < text.size() && longest > 0 && continues_letter(text[longest])) --longest;
  text = text.substr(0, longest);
  if (first_non_text(text)) return printable(text, longest / 4);
  std::string line(text);
  for (char& letter : line) {
    if (letter == '\n' || letter == '\r' || letter == '\t') letter = ' ';
  }
  return line;
}

std::string quote(std::string_view text) {
  return fmt::format("'{}'{}", printable(text, kLongest), text.size() > kLongest ? "..." : "");
}

std::string quote(char letter) {
  return is_printable(letter) ? fmt::format("'{}'", letter)
                              : fmt::format("0x{:02X}", byte_of(letter));
}

}  // namespace wend
