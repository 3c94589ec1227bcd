#pragma once

// Reads a number that has to be in a range, and says in words what is wrong with it.

#include <string>
#include <string_view>

namespace wend {

/// Sets `value` and returns an empty text; or returns what is wrong: "'9' is not between 0 and 5 m",
/// "'0,2' is not a number: the decimal point is a dot, did you mean 0.2?". The ends belong to the
/// range. Numbers that a double cannot hold are out of every range.
std::string parse_in_range(std::string_view text, double& value, double least, double greatest,
                           std::string_view unit = {});

}  // namespace wend
