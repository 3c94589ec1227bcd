#pragma once

// JumpQueue: the open states of a search that jumps, in buckets about one straight step wide.
//
// Each bucket is last in, first out. So keys are ordered only between buckets, and a search may have to
// expand a state again. Keys never fall below the current bucket. A push or pop takes O(1) plus the
// search for the next bucket, 64 buckets at a time. Nothing is allocated once the queue has its final
// size.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/base/state_id.hpp"

namespace wend {

template <class Cost>
class JumpQueue {
 public:
  struct Entry {
    Cost f;
    StateId id;
  };

  /// Removes all entries. `width_bits`: a bucket holds 2^width_bits keys; `least`: no key is below it.
  void begin(Cost least, unsigned width_bits) {
    for (std::size_t word = current_ / kWordBits; word < occupied_.size(); ++word) {
      for (; occupied_[word] != 0; occupied_[word] &= occupied_[word] - 1) {
        heads_[word * kWordBits + static_cast<std::size_t>(std::countr_zero(occupied_[word]))] =
            kNone;
      }
    }
    pushed_ = 0;
    least_ = least;
    width_bits_ = width_bits;
    current_ = 0;
    size_ = 0;
  }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void push(Cost f, StateId id) {
    const auto bucket = static_cast<std::size_t>((f - least_) >> width_bits_);
    if (bucket >= heads_.size()) add_buckets(bucket);
    if (pushed_ == links_.size()) add_links();
    links_[pushed_] = {{f, id}, heads_[bucket]};
    heads_[bucket] = pushed_++;
    occupied_[bucket / kWordBits] |= std::uint64_t{1} << (bucket % kWordBits);
    ++size_;
  }

  /// The last entry of the lowest bucket. The queue must not be empty.
  Entry pop() {
    std::size_t word = current_ / kWordBits;
    while (occupied_[word] == 0) ++word;
    current_ = word * kWordBits + static_cast<std::size_t>(std::countr_zero(occupied_[word]));
    const std::uint32_t link = heads_[current_];
    heads_[current_] = links_[link].next;
    const std::uint64_t empty = heads_[current_] == kNone ? 1 : 0;
    occupied_[word] ^= empty << (current_ % kWordBits);
    --size_;
    return links_[link].entry;
  }

  /// The bucket of a key.
  std::size_t bucket_of(Cost f) const {
    return static_cast<std::size_t>((f - least_) >> width_bits_);
  }

  /// Is the bucket of a key below the current one?
  bool bucket_is_behind(Cost f) const { return current_ > bucket_of(f); }

 private:
  static constexpr std::size_t kWordBits = 64;
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  struct Link {
    Entry entry;
    std::uint32_t next;
  };

  // Separate from the code of every push, so that push() stays short.
  [[gnu::noinline]] void add_links() { links_.resize(2 * links_.size() + kWordBits); }
  [[gnu::noinline]] void add_buckets(std::size_t bucket) {
    const std::size_t words = 2 * (bucket / kWordBits + 1);
    occupied_.resize(words);
    heads_.resize(words * kWordBits, kNone);
  }

  Cost least_ = 0;
  unsigned width_bits_ = 0;
  std::size_t current_ = 0;
  std::size_t size_ = 0;
  std::vector<std::uint64_t> occupied_;  // a bit for each bucket that is not empty
  std::vector<std::uint32_t> heads_;     // by bucket: its first link
  std::vector<Link> links_;
  std::uint32_t pushed_ = 0;  // links in use
};

}  // namespace wend
