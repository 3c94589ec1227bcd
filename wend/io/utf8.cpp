#include "wend/io/utf8.hpp"

#include <cstdint>

namespace wend {
namespace {

bool is_control(unsigned char byte) {
  return (byte < ' ' && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F;
}

/// How many bytes the character that begins with `lead` has; 0 if none begins so.
std::size_t length_of(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

/// A well-formed character of two to four bytes: no overlong form, no surrogate, at most U+10FFFF.
bool is_character(std::string_view bytes) {
  std::uint32_t code = static_cast<unsigned char>(bytes[0]) & (0x7FU >> bytes.size());
  for (const char next : bytes.substr(1)) {
    const auto byte = static_cast<unsigned char>(next);
    if ((byte & 0xC0U) != 0x80) return false;
    code = code << 6 | (byte & 0x3FU);
  }
  if (bytes.size() == 3) return code >= 0x800 && (code < 0xD800 || code > 0xDFFF);
  return bytes.size() != 4 || (code >= 0x10000 && code <= 0x10FFFF);
}

}  // namespace

std::optional<std::size_t> first_non_text(std::string_view bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const auto lead = static_cast<unsigned char>(bytes[at]);
    const std::size_t length = length_of(lead);
    if (length == 0 || length > bytes.size() - at || is_control(lead)) return at;
    if (length > 1 && !is_character(bytes.substr(at, length))) return at;
    at += length;
  }
  return std::nullopt;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

}  // namespace wend
