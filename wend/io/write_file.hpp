#pragma once

// Writing a file whole or not at all: the bytes go into a temporary file beside it, which then
// takes its name. A failure leaves what was there before, and so does a program that ends meanwhile,
// by Ctrl-C or by kill: on Linux the temporary file has no name until it is whole (O_TMPFILE), where
// the file system allows that.

#include <filesystem>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"

namespace wend {

/// A symbolic link stays one: its target is replaced. What is no regular file (a pipe,
/// /dev/stdout) is written straight.
Expected<void, IoError> write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace wend
