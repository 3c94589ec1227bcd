#pragma once

// Writes a file in full or not at all.

#include <filesystem>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/render/render_error.hpp"

namespace wend {

/// Into a temporary file beside it that is then renamed. What is no plain file (/dev/stdout, a
/// link) is written to directly.
Expected<void, RenderError> write_picture(const std::filesystem::path& file,
                                          std::string_view bytes);

}  // namespace wend
