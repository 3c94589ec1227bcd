#pragma once

// Numbers as text and back, the same on every platform. A program may bring its own number_text.cpp: the browser
// lab does, because the tables of <charconv> are a tenth of its size.

#include <string>
#include <string_view>
#include <system_error>

namespace wend {

/// The shortest text that read_number reads back as the same number, as std::to_chars writes it.
std::string shortest_text(double value);

/// Writes a number with the given number of significant digits (at most 20), as printf's %g does. The
/// magnitude is below 1e30.
std::string general_text(double value, int digits);

/// Parses the whole text, as std::from_chars does. Returns why it is not a number that a double holds; std::errc{}
/// if it is.
std::errc read_number(std::string_view text, double& value);

}  // namespace wend
