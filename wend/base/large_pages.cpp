#include "wend/base/large_pages.hpp"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wend {

void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21U;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t last = (begin + bytes) / kLargePage * kLargePage;
  if (memory != nullptr && last > first + kLargePage) {
    char* const from = static_cast<char*>(memory) + (first - begin);
    static_cast<void>(::madvise(from, last - first, MADV_HUGEPAGE));  // failure costs only speed
  }
#endif
}

}  // namespace wend
