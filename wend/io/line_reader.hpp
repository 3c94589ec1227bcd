#pragma once

// LineReader: the lines of a text, one after the other, with LF or CRLF line ends.
//
//   LineReader lines(text);
//   while (const auto line = lines.next()) ...  // lines.number() is the line's number, from 1

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace wend {

class LineReader {
 public:
  /// The text must outlive the reader and the lines that it returned.
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// The next line without its line end; nothing at the end of the text. A line end at the very
  /// end of the text starts no further line.
  std::optional<std::string_view> next();

  /// The number of the line that next() returned last, from 1; 0 before the first.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Without the blanks and tabs around it.
std::string_view trimmed(std::string_view text);

/// Nothing but blanks and tabs.
bool is_blank(std::string_view line);

/// The words of a line: what stands between blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line);

}  // namespace wend
