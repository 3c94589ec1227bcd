#pragma once

// What the CSV reports have in common.

#include <string>

namespace wend {

/// A field, in quotes where it needs them (RFC 4180).
std::string csv_field(const std::string& text);

}  // namespace wend
