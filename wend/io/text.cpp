#include "wend/io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace wend {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::size_t kLongestQuote = 40;

bool is_printable(char letter) { return letter >= ' ' && letter <= '~'; }
unsigned byte_of(char letter) { return static_cast<unsigned char>(letter); }

/// Whether a byte is a continuation byte of UTF-8.
bool continues_letter(char letter) { return (byte_of(letter) & 0xC0U) == 0x80U; }

bool is_control(unsigned byte) {
  return (byte < ' ' && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F;
}

/// The number of bytes of a character that begins with `lead`; 0 if no character begins with it.
std::size_t length_of_character(unsigned lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  return lead >= 0xF0 && lead <= 0xF4 ? 4 : 0;
}

/// Is it a well-formed character of two to four bytes: not overlong, not a surrogate, at most U+10FFFF?
bool is_character(std::string_view bytes) {
  std::uint32_t code = byte_of(bytes[0]) & (0x7FU >> bytes.size());
  for (const char next : bytes.substr(1)) {
    if (!continues_letter(next)) return false;
    code = code << 6 | (byte_of(next) & 0x3FU);
  }
  if (bytes.size() == 3) return code >= 0x800 && (code < 0xD800 || code > 0xDFFF);
  return bytes.size() != 4 || (code >= 0x10000 && code <= 0x10FFFF);
}

/// The number of bytes of the character that a text begins with; 0 if it is not UTF-8, or a control character other
/// than tab and line ends.
std::size_t leading_text(std::string_view text) {
  const unsigned lead = byte_of(text[0]);
  const std::size_t length = length_of_character(lead);
  if (length == 0 || length > text.size() || is_control(lead)) return 0;
  return length == 1 || is_character(text.substr(0, length)) ? length : 0;
}

/// Is a character of more bytes a control character: U+0080 to U+009F, a separator of lines, or one that turns the
/// direction of the text behind it?
bool is_long_control(std::string_view character) {
  if (character.size() == 2) return character[0] == '\xC2' && byte_of(character[1]) < 0xA0;
  if (character.size() != 3 || character[0] != '\xE2') return false;
  const auto last = byte_of(character[2]);
  return (character[1] == '\x80' && last >= 0xA8 && last <= 0xAE) ||
         (character[1] == '\x81' && last >= 0xA6 && last <= 0xA9);
}

bool has_long_control(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); at += leading_text(text.substr(at))) {
    if (is_long_control(text.substr(at, leading_text(text.substr(at))))) return true;
  }
  return false;
}

}  // namespace

std::string lower_case(std::string text) {
  for (char& letter : text) letter = lower_case(letter);
  return text;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, begin);
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find(separator);
    fields.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::string either_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  }
  return text;
}

std::optional<std::size_t> first_non_text(std::string_view bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const std::size_t length = leading_text(bytes.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

std::string quote(std::string_view text) {
  return fmt::format("'{}'{}", printable(text, kLongestQuote),
                     text.size() > kLongestQuote ? "..." : "");
}

std::string quote(char letter) {
  return is_printable(letter) ? fmt::format("'{}'", letter)
                              : fmt::format("0x{:02X}", byte_of(letter));
}

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
  if (first_non_text(text) || has_long_control(text)) return printable(text, longest / 4);
  std::string line(text);
  const auto breaks_line = [](char letter) {
    return letter == '\n' || letter == '\r' || letter == '\t';
  };
  std::ranges::replace_if(line, breaks_line, ' ');
  return line;
}

std::string visible(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = leading_text(text);
    const bool control = text[0] == '\r' || is_long_control(text.substr(0, length));
    const std::size_t count = std::max<std::size_t>(length, 1);
    shown += length == 0 || control ? printable(text, count) : std::string(text.substr(0, count));
    text.remove_prefix(count);
  }
  return shown;
}

std::optional<std::string_view> LineReader::next() {
  if (rest_.empty() && pieces_) rest_ = pieces_();
  if (rest_.empty()) return std::nullopt;
  ++number_;
  std::string_view line = rest_of_line();
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The text up to the next line end, which may lie in a later piece.
std::string_view LineReader::rest_of_line() {
  std::size_t end = rest_.find('\n');
  const auto take = [this, &end] {
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return taken;
  };
  if (end != std::string_view::npos || !pieces_) return take();
  joined_.clear();
  while (end == std::string_view::npos && !rest_.empty()) {
    joined_ += rest_;
    rest_ = pieces_();
    end = rest_.find('\n');
  }
  joined_ += take();
  return joined_;
}

}  // namespace wend
