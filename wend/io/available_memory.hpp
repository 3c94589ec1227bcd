#pragma once

// How much memory a program can still allocate before the system swaps or kills it: the memory that
// Linux reports as available, and the rest below the limits of its control groups (containers).

#include <cstdint>
#include <filesystem>
#include <optional>

#include "wend/base/compiler.hpp"

namespace wend {

/// Available bytes; nothing if the system does not report them. The file cache counts as available.
/// `root` is the folder of proc and sys.
WEND_API std::optional<std::uint64_t> available_memory(const std::filesystem::path& root = "/");

}  // namespace wend
