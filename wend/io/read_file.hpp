#pragma once

// Reading a file whole. Only regular files: a folder, a pipe or a device such as /dev/zero is
// refused before it is opened, so that no loader waits or reads for ever.

#include <cstddef>
#include <filesystem>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"

namespace wend {

/// Larger files are refused: the largest map with one byte a cell, and room for line ends.
inline constexpr std::size_t kLargestFile = std::size_t{3} << 30;

/// The bytes of `file`, at most `largest` of them.
Expected<std::string, IoError> read_file(const std::filesystem::path& file,
                                         std::size_t largest = kLargestFile);

}  // namespace wend
