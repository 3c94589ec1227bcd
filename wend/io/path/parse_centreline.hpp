#pragma once

// Reading a centreline in metres; see load_path.hpp.

#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/io/io_error.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// Of a text with the header of no other path.
Expected<Path, IoError> parse_centreline(std::string_view text, const std::string& file,
                                         const Frame& frame);

}  // namespace wend
