#include "wend/io/quote.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace wend {
namespace {

constexpr std::size_t kLongest = 40;

bool is_printable(char letter) { return letter >= ' ' && letter <= '~'; }
unsigned code_of(char letter) { return static_cast<unsigned char>(letter); }

}  // namespace

std::string quote(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text.substr(0, kLongest)) {
    quoted +=
        is_printable(letter) ? std::string(1, letter) : fmt::format("\\x{:02X}", code_of(letter));
  }
  return quoted + (text.size() > kLongest ? "'..." : "'");
}

std::string quote(char letter) {
  return is_printable(letter) ? fmt::format("'{}'", letter)
                              : fmt::format("0x{:02X}", code_of(letter));
}

}  // namespace wend
