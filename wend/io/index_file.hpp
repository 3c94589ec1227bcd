#pragma once

// Indexes in files: written whole or not at all, and mapped: what a query does not touch is not read,
// and programs share the memory.

#include <filesystem>

#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/io/io_error.hpp"

namespace wend {

Expected<void, IoError> write_index(const std::filesystem::path& file, const IndexBytes& index);

/// Maps a file. Whether it is an index, and of what, its reader says. It must not be written to while it
/// is open; a new one that takes its name does no harm.
Expected<IndexBytes, IoError> open_index(const std::filesystem::path& file);

}  // namespace wend
