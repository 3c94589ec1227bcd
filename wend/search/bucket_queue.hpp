#pragma once

// BucketQueue: the open states of a search in whole numbers, in buckets of equal width.
//
// Each bucket is last in, first out, so keys are ordered only between buckets: a search may have to expand a
// state again, and has to go on until the bucket of its best goal is done. push() takes keys that do not fall
// below the current bucket. A window of kBuckets buckets holds the entries that are due soon, as lists; the others
// wait in one far list, which is sorted into buckets when the window has come to its end. So keys can be any distance
// ahead. A push or pop takes O(1), plus the search for the next bucket, 64 buckets at a time. Memory of
// popped entries is used again; nothing is allocated once the queue has its final size.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wend {

template <class Entry>
class BucketQueue {
 public:
  /// Removes all entries. `width_bits`: a bucket holds 2^width_bits keys; `least`: no key is below it.
  void begin(std::uint64_t least, unsigned width_bits) {
    for (std::size_t word = 0; word < kWords; ++word) {
      for (; occupied_[word] != 0; occupied_[word] &= occupied_[word] - 1) {
        heads_[word * kWordBits + static_cast<std::size_t>(std::countr_zero(occupied_[word]))] =
            kNone;
      }
    }
    links_.clear();
    unused_ = kNone;
    far_.clear();
    width_bits_ = width_bits;
    first_ = least >> width_bits;
    current_ = 0;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void push(std::uint64_t key, const Entry& entry) {
    const std::uint64_t bucket = (key >> width_bits_) - first_;
    ++size_;
    if (bucket >= kBuckets) {
      far_.push_back({key, entry});
      return;
    }
    assert(bucket >= current_);
    std::uint32_t link = unused_;
    if (link == kNone) {
      link = static_cast<std::uint32_t>(links_.size());
      links_.push_back({});
    } else {
      unused_ = links_[link].next;
    }
    links_[link] = {entry, heads_[bucket]};
    heads_[bucket] = link;
    occupied_[bucket / kWordBits] |= std::uint64_t{1} << (bucket % kWordBits);
  }

  /// Goes on to the lowest bucket with entries, which pop() takes next, and returns the least key that it may
  /// hold. The queue must not be empty.
  std::uint64_t seek() {
    std::size_t word = current_ / kWordBits;
    while (occupied_[word] == 0) {
      if (++word == kWords) {
        move_window();
        word = 0;
      }
    }
    current_ = word * kWordBits + static_cast<std::size_t>(std::countr_zero(occupied_[word]));
    return least_key();
  }

  /// The last entry of the lowest bucket. The queue must not be empty.
  Entry pop() {
    seek();
    const std::size_t word = current_ / kWordBits;
    const std::uint32_t link = heads_[current_];
    heads_[current_] = links_[link].next;
    const std::uint64_t empty = heads_[current_] == kNone ? 1 : 0;
    occupied_[word] ^= empty << (current_ % kWordBits);
    links_[link].next = unused_;
    unused_ = link;
    --size_;
    return links_[link].entry;
  }

  /// The entry that would be popped after the next one if nothing is pushed, if it is in the same bucket; else null.
  const Entry* after_next() const {
    const std::uint32_t next = heads_[current_];
    if (next == kNone) return nullptr;
    const std::uint32_t after = links_[next].next;
    return after == kNone ? nullptr : &links_[after].entry;
  }

  /// No key of the bucket popped last is below this, nor will any later one be.
  std::uint64_t least_key() const { return (first_ + current_) << width_bits_; }
  /// All keys of that bucket are below this.
  std::uint64_t end_of_bucket() const { return (first_ + current_ + 1) << width_bits_; }

 private:
  static constexpr std::size_t kBuckets = 4096;
  static constexpr std::size_t kWordBits = 64;
  static constexpr std::size_t kWords = kBuckets / kWordBits;
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  struct Link {
    Entry entry;
    std::uint32_t next;
  };
  struct FarEntry {
    std::uint64_t key;
    Entry entry;
  };

  static constexpr std::array<std::uint32_t, kBuckets> no_heads() {
    std::array<std::uint32_t, kBuckets> heads{};
    heads.fill(kNone);
    return heads;
  }

  /// Begins the window at the least far key. There must be one.
  [[gnu::noinline]] void move_window() {
    const auto least =
        std::min_element(far_.begin(), far_.end(),
                         [](const FarEntry& a, const FarEntry& b) { return a.key < b.key; });
    begin_window(least->key >> width_bits_);
  }

  /// Moves the far entries that lie in a window from this bucket on into it.
  void begin_window(std::uint64_t first) {
    first_ = first;
    current_ = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < far_.size(); ++i) {
      const FarEntry far = far_[i];
      if ((far.key >> width_bits_) - first_ >= kBuckets) {
        far_[kept++] = far;
      } else {
        push(far.key, far.entry);
        --size_;
      }
    }
    far_.resize(kept);
  }

  unsigned width_bits_ = 0;
  std::uint64_t first_ = 0;  // the first bucket of the window, counted from key 0
  std::size_t current_ = 0;  // in the window
  std::size_t size_ = 0;
  std::array<std::uint64_t, kWords> occupied_{};            // a bit for each bucket with entries
  std::array<std::uint32_t, kBuckets> heads_ = no_heads();  // by bucket: its first link
  std::vector<Link> links_;
  std::uint32_t unused_ = kNone;  // the first link without an entry
  std::vector<FarEntry> far_;
};

}  // namespace wend
