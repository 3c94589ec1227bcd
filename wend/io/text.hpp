#pragma once

// Text functions for file readers: split text into lines and words, check that it is UTF-8, and quote it
// in error messages. Letters are ASCII letters, the same in every locale; blanks are spaces and tabs.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"

namespace wend {

/// The lower-case letter of an ASCII letter; other bytes stay.
constexpr char lower_case(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}
/// The same for every byte of a text.
WEND_API std::string lower_case(std::string text);

/// The text without the blanks around it.
WEND_API std::string_view trimmed(std::string_view text);

/// Whether a line has only blanks.
WEND_API bool is_blank(std::string_view line);

/// The words of a line, separated by blanks.
WEND_API std::vector<std::string_view> words_of(std::string_view line);

/// The fields between separators: one more than there are separators.
WEND_API std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// "a, b or c"
WEND_API std::string either_of(const std::vector<std::string>& names);

/// The position of the first byte that is not valid UTF-8, or is a control character other than tab and
/// line ends. Nothing if all bytes are text. O(n).
WEND_API std::optional<std::size_t> first_non_text(std::string_view bytes);

/// The text without the byte-order mark that some editors put before it: EF BB BF.
WEND_API std::string_view without_byte_order_mark(std::string_view text);

/// 'text' in single quotes, for error messages: at most the first 40 bytes, then "..."; bytes that are
/// not printable ASCII as `\xNN`.
WEND_API std::string quote(std::string_view text);
/// The same for one byte.
WEND_API std::string quote(char letter);

/// The same without quotes, and at most the first `longest` bytes.
WEND_API std::string printable(std::string_view text, std::size_t longest);

/// The first `longest` bytes as one line for people: other alphabets stay where the text is UTF-8, line
/// ends and tabs become blanks. Other bytes are shown as by printable(), and only the first quarter of
/// them, so that the result has at most `longest` bytes.
WEND_API std::string text_line(std::string_view text, std::size_t longest);

/// The text as a terminal may show it: bytes that are not UTF-8, and control characters other than tab and line feed, as
/// `\xNN`. Names come from other people, and such characters can move the cursor or do worse.
WEND_API std::string visible(std::string_view text);

/// The lines of a text, one after the other, with LF or CRLF line ends. A byte-order mark at the
/// beginning is skipped.
///
///   LineReader lines(text);
///   while (const auto line = lines.next()) ...  // lines.number() is the line's number, from 1
class WEND_API LineReader {
 public:
  /// Gives the text piece by piece, an empty piece at its end. A piece is valid until the next call.
  using Pieces = std::function<std::string_view()>;

  /// The text must outlive the reader and the lines that it returned.
  explicit LineReader(std::string_view text)
      : rest_(without_byte_order_mark(text)), size_(text.size()) {}

  /// Reads a text of about `size` bytes that is not in memory as a whole. A line is valid until the
  /// next one is read.
  LineReader(Pieces pieces, std::size_t size)
      : pieces_(std::move(pieces)), rest_(without_byte_order_mark(pieces_())), size_(size) {}

  /// The next line without its line end; nothing at the end of the text. A line end at the very
  /// end of the text starts no further line.
  std::optional<std::string_view> next();

  /// The approximate number of bytes of the whole text.
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

}  // namespace wend
