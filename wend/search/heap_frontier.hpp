#pragma once

// HeapFrontier: open states in a heap, for keys of any kind. O(log n) a push and a pop.
//
// A state that is reached more cheaply is pushed again; the search passes over the older entry when
// it comes out (it is closed by then).

#include <cstdint>
#include <vector>

#include "wend/search/frontier_entry.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {

template <class OrderedKey>
class HeapFrontier {
 public:
  using Key = OrderedKey;
  using Entry = FrontierEntry<Key>;

  void clear() {
    entries_.clear();
    age_rank_ = UINT32_MAX;
  }
  bool empty() const { return entries_.empty(); }
  void push(Key key, StateId id) { min_heap::push(entries_, Entry{key, age_rank_--, id}); }
  Entry pop() { return min_heap::pop(entries_); }

 private:
  std::vector<Entry> entries_;
  std::uint32_t age_rank_ = UINT32_MAX;
};

}  // namespace wend
