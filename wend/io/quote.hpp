#pragma once

// Quoting a file's own words in an error message: they may be long, or no text at all.

#include <string>
#include <string_view>

namespace wend {

/// 'text' in single quotes: bytes that are not printable ASCII as \xNN, and no more than the first
/// 40 bytes, then "...".
std::string quote(std::string_view text);

/// A single letter: 'x', or 0x09 where it is not printable ASCII.
std::string quote(char letter);

}  // namespace wend
