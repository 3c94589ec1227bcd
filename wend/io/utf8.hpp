#pragma once

// Whether bytes are text.

#include <cstddef>
#include <optional>
#include <string_view>

namespace wend {

/// Where a text first breaks the rules: a byte that is not valid UTF-8, or a control character
/// other than tab and line ends. Nothing if it is text throughout. O(n).
std::optional<std::size_t> first_non_text(std::string_view bytes);

/// Without the mark that some editors put before a text: EF BB BF.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace wend
