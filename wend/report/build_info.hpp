#pragma once

// The version of wend, for results that are stored.

#include <string_view>

namespace wend {

/// "0.2.0"
std::string_view wend_version();

/// The commit that was built, followed by "-dirty" if files had been changed; "unknown" outside a git
/// checkout. (cmake/commit.cmake writes its source.)
std::string_view wend_commit();

}  // namespace wend
