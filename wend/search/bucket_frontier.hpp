#pragma once

// BucketFrontier: open states by whole-number keys that never fall (f of a consistent heuristic).
//
// A ring of buckets, each as wide as a small part of a straight step. Only the bucket in hand is
// ordered, as a small heap; the others are lists that are ordered when their turn comes. So states
// come out exactly as from a HeapFrontier, in O(1) for most of them. (R. Dial, "Algorithm 360:
// Shortest-path forest with topological ordering", 1969, with a heap in the bucket.)
//
// Key has `f()`, a whole number, and `<`. No key may be smaller than the one popped last (before
// that, than the first one pushed), nor a turn of the ring or more above it.

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/search/frontier_entry.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {

template <class OrderedKey, unsigned kBucketBits>
class BucketFrontier {
 public:
  using Key = OrderedKey;
  using Entry = FrontierEntry<Key>;

  void clear() {
    for (std::size_t word = 0; word < kWords; ++word) {
      for (std::uint64_t bits = occupied_[word]; bits != 0; bits &= bits - 1) {
        ring_[word * 64 + static_cast<std::size_t>(std::countr_zero(bits))].clear();
      }
      occupied_[word] = 0;
    }
    current_ = kNoBucket;
    size_ = 0;
    age_rank_ = UINT32_MAX;
  }

  bool empty() const { return size_ == 0; }

  void push(Key key, StateId id) {
    const std::uint64_t bucket = static_cast<std::uint64_t>(key.f()) >> kBucketBits;
    if (current_ == kNoBucket) current_ = bucket;
    assert(bucket >= current_ && bucket - current_ < kBuckets);
    const Entry entry{key, age_rank_--, id};
    const std::size_t slot = bucket % kBuckets;
    occupied_[slot / 64] |= std::uint64_t{1} << (slot % 64);
    if (bucket == current_) {
      min_heap::push(ring_[slot], entry);
    } else {
      ring_[slot].push_back(entry);
    }
    ++size_;
  }

  Entry pop() {
    std::size_t slot = current_ % kBuckets;
    if (ring_[slot].empty()) slot = advance();
    const Entry entry = min_heap::pop(ring_[slot]);
    if (ring_[slot].empty()) occupied_[slot / 64] &= ~(std::uint64_t{1} << (slot % 64));
    --size_;
    return entry;
  }

 private:
  static constexpr std::size_t kBuckets = 256;
  static constexpr std::size_t kWords = kBuckets / 64;
  static constexpr std::uint64_t kNoBucket = UINT64_MAX;

  /// Goes on to the next bucket that is not empty, and orders it.
  std::size_t advance() {
    const std::size_t from = current_ % kBuckets;
    std::size_t word = from / 64;
    std::uint64_t bits = occupied_[word] & (~std::uint64_t{0} << (from % 64));
    while (bits == 0) {
      word = (word + 1) % kWords;
      bits = occupied_[word];
    }
    const std::size_t slot = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
    current_ += (slot - from) % kBuckets;
    min_heap::make(ring_[slot]);
    return slot;
  }

  std::array<std::vector<Entry>, kBuckets> ring_;
  std::array<std::uint64_t, kWords> occupied_{};
  std::uint64_t current_ = kNoBucket;  // the bucket in hand, counted from key 0
  std::size_t size_ = 0;
  std::uint32_t age_rank_ = UINT32_MAX;
};

}  // namespace wend
