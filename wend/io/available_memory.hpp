#pragma once

// How much memory a program can still take before the system swaps or ends it: what Linux says is
// available, and what is left below the limits of the control groups (containers) it runs in.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace wend {

/// Bytes; nothing where the system does not say. Files that the system keeps in memory count as
/// available. `root` is where proc and sys lie.
std::optional<std::uint64_t> available_memory(const std::filesystem::path& root = "/");

}  // namespace wend
