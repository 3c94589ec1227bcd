#pragma once

// Which wend this is. Results that are kept say so.

#include <string_view>

namespace wend {

/// "0.2.0"
std::string_view wend_version();

/// The commit that was built, "-dirty" behind it if files had been changed; "unknown" outside of a git
/// checkout. (Its source is written by cmake/commit.cmake.)
std::string_view wend_commit();

}  // namespace wend
