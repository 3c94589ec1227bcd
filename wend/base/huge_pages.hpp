#pragma once

// Huge pages: memory in pieces of 2 MiB instead of 4 KiB, so that reading large tables here and
// there misses the cache for addresses less often.

#include <cstddef>

namespace wend {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21U;

/// Asks the system for them, before the memory is touched for the first time. Where there are none,
/// nothing happens.
void ask_for_huge_pages(void* begin, std::size_t bytes);

}  // namespace wend
