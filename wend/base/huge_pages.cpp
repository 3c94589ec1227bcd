#include "wend/base/huge_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wend {

void ask_for_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  // A refusal costs nothing but speed.
  static_cast<void>(::madvise(begin, bytes, MADV_HUGEPAGE));
#endif
}

}  // namespace wend
