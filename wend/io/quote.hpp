#pragma once

// Quoting a file's own words in an error message: they may be long, or no text at all.

#include <cstddef>
#include <string>
#include <string_view>

namespace wend {

/// 'text' in single quotes: bytes that are not printable ASCII as \xNN, and no more than the first
/// 40 bytes, then "...".
std::string quote(std::string_view text);

/// The same without quotes, and no more than the first `longest` bytes: for what a library says of
/// a file.
std::string printable(std::string_view text, std::size_t longest);

/// The first `longest` bytes as one line for people: letters of other alphabets stay where the text
/// is UTF-8, line ends and tabs become blanks. Other bytes are shown as by printable(), and only the
/// first quarter of them, so that the result has at most `longest` bytes.
std::string text_line(std::string_view text, std::size_t longest);

/// What is kept of a plan's status and reason that stand in a file.
inline constexpr std::size_t kLongestStatus = 40;
inline constexpr std::size_t kLongestReason = 1000;

/// A single letter: 'x', or 0x09 where it is not printable ASCII.
std::string quote(char letter);

}  // namespace wend
