#pragma once

// Large tables of plain values that begin as zeros. The system allocates pages only where they are touched,
// and is asked for large ones, with which searches on large maps wait less for addresses.

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace wend {

/// For memory from std::calloc().
struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// `count` values of `size` bytes, all zero; null if there is no memory.
void* zeroed_memory(std::size_t count, std::size_t size);

template <class Value>
using ZeroedTable = std::unique_ptr<Value[], FreeMemory>;

/// Null if there is no memory.
template <class Value>
ZeroedTable<Value> zeroed_table(std::size_t count) {
  return ZeroedTable<Value>(static_cast<Value*>(zeroed_memory(count, sizeof(Value))));
}

}  // namespace wend
