#pragma once

// LineReader: the lines of a text, one after the other, with LF or CRLF line ends. A byte-order mark
// at its beginning is skipped.
//
//   LineReader lines(text);
//   while (const auto line = lines.next()) ...  // lines.number() is the line's number, from 1

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/io/utf8.hpp"

namespace wend {

class LineReader {
 public:
  /// Gives the text piece by piece, an empty one at its end. A piece stays as it is until the next.
  using Pieces = std::function<std::string_view()>;

  /// The text must outlive the reader and the lines that it returned.
  explicit LineReader(std::string_view text)
      : rest_(without_byte_order_mark(text)), size_(text.size()) {}

  /// Of a text of about `size` bytes that is not in memory as a whole: a line is valid until the
  /// next one is asked for.
  LineReader(Pieces pieces, std::size_t size)
      : pieces_(std::move(pieces)), rest_(without_byte_order_mark(pieces_())), size_(size) {}

  /// The next line without its line end; nothing at the end of the text. A line end at the very
  /// end of the text starts no further line.
  std::optional<std::string_view> next();

  /// How many bytes the whole text has, about.
  std::size_t size() const { return size_; }

  /// The number of the line that next() returned last, from 1; 0 before the first.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_of_line();

  Pieces pieces_;
  std::string_view rest_;  // of the text, or of this piece
  std::string joined_;     // a line that lies in several pieces
  std::size_t size_;
  std::size_t number_ = 0;
};

/// Without the blanks and tabs around it.
std::string_view trimmed(std::string_view text);

/// Nothing but blanks and tabs.
bool is_blank(std::string_view line);

/// The words of a line: what stands between blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line);

}  // namespace wend
