#pragma once

// BucketQueue: open states by whole numbers, in buckets of equal width. The one such queue; searches differ in what they
// do with a bucket:
//
// - With NewestFirst, pop() takes the entry of the lowest bucket that was pushed last. So keys are ordered only between
//   buckets: a search may have to expand a state again, and has to go on until the bucket of its best goal is done.
// - With SmallestFirst, pop() takes the smallest entry of all; entries with smaller keys must
//   be smaller. A bucket is sorted when it becomes the lowest, and keeps sorted. That is fast where what is pushed into
//   it then is smaller than most of it.
// - With NewestOfFalling, the same, and keys may also fall below the current bucket, as those of a weighted search do.
//   Those that fall by more than the ring holds come into its first bucket.
// - take_bucket() takes the whole lowest bucket, for whoever expands it in the order of the pushes. What is pushed into
//   that bucket later makes up another one with the same keys.
//
// Else push() takes keys that do not fall below the current bucket. A ring of kBuckets buckets holds the entries that are due
// soon. With NewestFirst, those beyond wait in one far list, which is sorted into buckets when the ring is empty; so keys
// can be any distance ahead. With SmallestFirst, keys have to be within the ring. A push or pop takes O(1), plus the search
// for the next bucket, 64 buckets at a time. Nothing is allocated once the buckets have their final sizes.
// R. Dial, "Algorithm 360: Shortest-path forest with topological ordering", 1969.

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace wend {

struct NewestFirst {};
struct NewestOfFalling {};
struct SmallestFirst {};

template <class Entry, class Order = NewestFirst, std::size_t kBuckets = 4096>
class BucketQueue {
 public:
  /// With SmallestFirst: the first key that is pushed will be the least one.
  static constexpr std::uint64_t kUnknown = UINT64_MAX;

  /// Removes all entries. `width_bits`: a bucket holds 2^width_bits keys; `least`: no key is below it.
  void begin(std::uint64_t least, unsigned width_bits) {
    for (std::size_t word = 0; word < kWords; ++word) {
      for (; occupied_[word] != 0; occupied_[word] &= occupied_[word] - 1) {
        ring_[word * kWordBits + static_cast<std::size_t>(std::countr_zero(occupied_[word]))]
            .clear();
      }
    }
    far_.clear();
    size_ = 0;
    width_bits_ = width_bits;
    go_to(least == kUnknown ? kUnknown : least >> width_bits);
  }

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }

  void push(std::uint64_t key, const Entry& entry) {
    std::uint64_t number = key >> width_bits_;
    ++size_;
    if constexpr (kFalls) {
      number = std::max(number, horizon_ - kBuckets);
      if (number < current_) fall_to(number);
    }
    if constexpr (kSorts) {
      if (current_ == kUnknown) current_ = number;
      assert(number - current_ < kBuckets);
    } else {
      assert(number >= current_);
      if (number >= horizon_) return push_far(key, entry);
    }
    const std::size_t slot = number % kBuckets;
    ring_[slot].push_back(entry);
    occupied_[slot / kWordBits] |= std::uint64_t{1} << (slot % kWordBits);
    if constexpr (kSorts) {
      if (number == current_) move_to_its_place(ring_[slot], ring_[slot].size() - 1);
    }
  }

  /// Takes an entry of the lowest bucket. The queue must not be empty.
  Entry pop() {
    std::vector<Entry>& bucket = lowest();
    const Entry entry = bucket.back();
    bucket.pop_back();
    --size_;
    return entry;
  }

  /// Moves the entries of the lowest bucket into a vector, in the order of their pushes. The queue must not be empty.
  /// The bucket keeps its memory, so that a search that is repeated takes none.
  void take_bucket(std::vector<Entry>& taken) {
    std::vector<Entry>& bucket = lowest();
    taken.assign(bucket.begin(), bucket.end());
    bucket.clear();
    size_ -= taken.size();
  }

  /// The entry that would be popped after the next one if nothing is pushed, if it is in the same bucket; else null.
  const Entry* after_next() const {
    const std::vector<Entry>& bucket = ring_[current_ % kBuckets];
    return bucket.size() < 2 ? nullptr : &bucket[bucket.size() - 2];
  }

  /// No key of the bucket popped last is below this; unless keys fall, nor will any later one be.
  std::uint64_t least_key() const { return current_ << width_bits_; }
  /// All keys of that bucket are below this.
  std::uint64_t end_of_bucket() const { return (current_ + 1) << width_bits_; }

 private:
  static constexpr bool kSorts = std::is_same_v<Order, SmallestFirst>;
  static constexpr bool kFalls = std::is_same_v<Order, NewestOfFalling>;
  static constexpr std::size_t kWordBits = 64;
  static constexpr std::size_t kWords = kBuckets / kWordBits;

  struct FarEntry {
    std::uint64_t key;
    Entry entry;
  };

  // Separate from the code of every push, so that push() stays short.
  [[gnu::noinline]] void push_far(std::uint64_t key, const Entry& entry) {
    far_.push_back({key, entry});
  }

  /// Goes back to a bucket of the ring.
  void fall_to(std::uint64_t number) {
    const std::size_t slot = current_ % kBuckets;
    if (ring_[slot].empty()) {
      occupied_[slot / kWordBits] &= ~(std::uint64_t{1} << (slot % kWordBits));
    }
    current_ = number;
  }

  std::vector<Entry>& lowest() {
    const std::size_t slot = current_ % kBuckets;
    return ring_[slot].empty() ? next_bucket() : ring_[slot];
  }

  /// Goes on from an empty bucket to the lowest one with entries.
  std::vector<Entry>& next_bucket() {
    const std::size_t from = current_ % kBuckets;
    occupied_[from / kWordBits] &= ~(std::uint64_t{1} << (from % kWordBits));
    if constexpr (!kSorts) {
      if (size_ == far_.size()) return ring_[fetch_far()];
    }
    std::size_t word = from / kWordBits;
    std::uint64_t bits = occupied_[word] & (~std::uint64_t{0} << (from % kWordBits));
    while (bits == 0) {
      word = (word + 1) % kWords;
      bits = occupied_[word];
    }
    const std::size_t slot = word * kWordBits + static_cast<std::size_t>(std::countr_zero(bits));
    current_ += (slot - from) % kBuckets;
    if constexpr (kFalls) return ring_[slot];
    if constexpr (!kSorts) {
      // What is far stays beyond the horizon, or an entry could come into a bucket before older ones.
      if (far_.empty()) horizon_ = current_ + kBuckets;
    } else {
      sort(ring_[slot]);
    }
    return ring_[slot];
  }

  static void sort(std::vector<Entry>& bucket) {
    constexpr std::size_t kFew = 16;  // as most buckets have
    if (bucket.size() > kFew) {
      std::sort(bucket.begin(), bucket.end(), [](const Entry& a, const Entry& b) { return b < a; });
    } else {
      for (std::size_t i = 1; i < bucket.size(); ++i) move_to_its_place(bucket, i);
    }
  }

  /// Moves an entry to its place among the sorted ones in front of it.
  static void move_to_its_place(std::vector<Entry>& bucket, std::size_t at) {
    const Entry entry = bucket[at];
    for (; at > 0 && bucket[at - 1] < entry; --at) bucket[at] = bucket[at - 1];
    bucket[at] = entry;
  }

  /// Goes on to the least far key, and moves the far entries that are due soon into the ring, which is empty. Returns the
  /// slot.
  [[gnu::noinline]] std::size_t fetch_far() {
    const auto least =
        std::min_element(far_.begin(), far_.end(),
                         [](const FarEntry& a, const FarEntry& b) { return a.key < b.key; });
    go_to(least->key >> width_bits_);
    auto kept = far_.begin();
    for (const FarEntry far : far_) {
      if (far.key >> width_bits_ >= horizon_) {
        *kept++ = far;
        continue;
      }
      --size_;  // push() counts it again
      push(far.key, far.entry);
    }
    far_.erase(kept, far_.end());
    return current_ % kBuckets;
  }

  void go_to(std::uint64_t number) {
    current_ = number;
    horizon_ = number + kBuckets;
  }

  unsigned width_bits_ = 0;
  // Buckets, counted from key 0.
  std::uint64_t current_ = 0;
  std::uint64_t horizon_ = kBuckets;  // entries from this one on are far
  std::size_t size_ = 0;
  std::array<std::uint64_t, kWords>
      occupied_{};  // a bit for each bucket with entries; also for the current one
  std::array<std::vector<Entry>, kBuckets> ring_;
  std::vector<FarEntry> far_;
};

}  // namespace wend
