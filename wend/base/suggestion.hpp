#pragma once

// "Did you mean ...?": the known name nearest to a misspelt one.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wend {

/// The name with the smallest edit distance to `typed` (letters put in, left out, changed or swapped
/// with their neighbour), if at most a third of its letters differ. O(|typed| * total length of
/// names).
std::optional<std::string> closest_name(std::string_view typed, std::span<const std::string> names);

}  // namespace wend
