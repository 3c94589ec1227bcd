#include "wend/index/file/index_bytes.hpp"

#include <cstdlib>
#include <cstring>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wend {
namespace {

// Huge pages are memory in pieces of 2 MiB instead of 4 KiB, so that reading large tables here and
// there misses the cache for addresses less often.
constexpr std::size_t kHugePage = std::size_t{1} << 21U;

/// Asks the system for huge pages, before the memory is touched for the first time. Where there are
/// none, nothing happens.
void ask_for_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  static_cast<void>(::madvise(begin, bytes, MADV_HUGEPAGE));  // a refusal costs nothing but speed
#endif
}

}  // namespace

IndexBytes IndexBytes::copy_of(std::span<const std::byte> bytes) {
  if (bytes.empty()) return {};
  const std::size_t page = bytes.size() < kHugePage ? kAlignment : kHugePage;
  const std::size_t room = (bytes.size() + page - 1) / page * page;
  std::shared_ptr<std::byte> memory(static_cast<std::byte*>(std::aligned_alloc(page, room)),
                                    [](std::byte* begin) { std::free(begin); });
  if (memory == nullptr) std::abort();  // as new does without exceptions
  if (page == kHugePage) ask_for_huge_pages(memory.get(), room);
  std::memcpy(memory.get(), bytes.data(), bytes.size());
  const std::span<const std::byte> copy(memory.get(), bytes.size());
  return {std::move(memory), copy};
}

}  // namespace wend
