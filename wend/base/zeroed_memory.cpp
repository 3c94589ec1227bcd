#include "wend/base/zeroed_memory.hpp"

#include "wend/base/large_pages.hpp"

namespace wend {

void* zeroed_memory(std::size_t count, std::size_t size) {
  void* const memory = std::calloc(count, size);
  ask_for_large_pages(memory, count * size);
  return memory;
}

}  // namespace wend
