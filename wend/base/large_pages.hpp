#pragma once

// LargePages: an allocator for vectors of many values that are read in no order. The system is asked for large pages,
// with which searches on large maps wait less for addresses.

#include <cstddef>
#include <new>

namespace wend {

/// Tells the system that memory would do well on large pages. Does nothing where there are none, or the memory is
/// small.
void ask_for_large_pages(void* memory, std::size_t bytes);

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class Other>
  explicit(false) LargePages(const LargePages<Other>& /*other*/) {}

  T* allocate(std::size_t count) {
    void* const memory = ::operator new(count * sizeof(T), std::align_val_t{alignof(T)});
    ask_for_large_pages(memory, count * sizeof(T));
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t /*count*/) {
    ::operator delete(memory, std::align_val_t{alignof(T)});
  }

  friend bool operator==(const LargePages&, const LargePages&) = default;
};

}  // namespace wend
