#include "wend/index/file/index_bytes.hpp"

#include <cstdlib>
#include <cstring>

#include "wend/base/huge_pages.hpp"

namespace wend {

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
