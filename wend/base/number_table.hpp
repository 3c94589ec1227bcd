#pragma once

// NumberTable: a hash table from keys of 64 bits to numbers, such as those of nodes. The one that is cleared in O(1):
// a slot counts only if it has the stamp of the last clear(). When the stamps run out, all slots are cleared once.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "wend/base/large_pages.hpp"

namespace wend {

template <class Stamp = std::uint32_t>
class NumberTable {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void clear() {
    count_ = 0;
    if (++stamp_ != 0) return;
    slots_.assign(slots_.size(), {});
    stamp_ = 1;
  }

  /// The number of a key, for reading and writing; kNone if it has none yet. Valid until the next call.
  std::uint32_t& operator[](std::uint64_t key) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slot_of(key);
    if (slot.stamp != stamp_) {
      slot = {key, kNone, stamp_};
      ++count_;
    }
    return slot.number;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = kNone;
    Stamp stamp = 0;
  };

  /// The slot of a key, or the empty one where it belongs.
  Slot& slot_of(std::uint64_t key) {
    auto i = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15U) >> shift_);
    while (slots_[i].stamp == stamp_ && slots_[i].key != key)
      i = i + 1 == slots_.size() ? 0 : i + 1;
    return slots_[i];
  }

  [[gnu::noinline]] void grow() {
    std::vector<Slot, LargePages<Slot>> old(slots_.empty() ? kFirst : 2 * slots_.size());
    old.swap(slots_);
    shift_ = 64 - std::countr_zero(slots_.size());
    for (const Slot& slot : old) {
      if (slot.stamp == stamp_) slot_of(slot.key) = slot;
    }
  }

  static constexpr std::size_t kFirst = 64;  // a power of two, as all later sizes

  std::vector<Slot, LargePages<Slot>> slots_;  // at least twice as many as keys
  std::size_t count_ = 0;
  int shift_ = 0;
  Stamp stamp_ = 1;
};

}  // namespace wend
