#pragma once

// Results go to standard output, everything else to standard error.

#include <string_view>

namespace wend::cli {

/// Writes a result. Errors show in finish_output().
void print(std::string_view text);

/// Writes a line for people to standard error: "wend: <text>".
void complain(std::string_view text);

/// Writes what is still buffered. False if results were lost, but for a reader who went away
/// (`wend ... | head`): that is no error.
bool finish_output();

}  // namespace wend::cli
