#pragma once

// The frontiers of a forward search: open states ordered by arrival (FifoFrontier, LifoFrontier) or by
// key (HeapFrontier, BucketFrontier).

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/bucket_queue.hpp"
#include "wend/base/state_id.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {

/// The key of frontiers that do not order states by key.
struct NoKey {};

struct UnorderedEntry {
  NoKey key;
  StateId id;
};

/// First in, first out: a ring buffer that doubles when it is full. Push and pop take O(1).
class FifoFrontier {
 public:
  using Key = NoKey;

  void clear() { first_ = size_ = 0; }
  bool empty() const { return size_ == 0; }

  void push(NoKey /*key*/, StateId id) {
    if (size_ == ring_.size()) grow();
    ring_[(first_ + size_) & (ring_.size() - 1)] = id;
    ++size_;
  }

  UnorderedEntry pop() {
    const StateId id = ring_[first_];
    first_ = (first_ + 1) & (ring_.size() - 1);
    --size_;
    return {{}, id};
  }

 private:
  static constexpr std::size_t kFirstCapacity = 64;  // a power of two, as all later ones

  void grow() {
    std::vector<StateId> larger(ring_.empty() ? kFirstCapacity : 2 * ring_.size());
    for (std::size_t i = 0; i < size_; ++i) larger[i] = ring_[(first_ + i) & (ring_.size() - 1)];
    ring_.swap(larger);
    first_ = 0;
  }

  std::vector<StateId> ring_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Last in, first out. Push and pop take O(1).
class LifoFrontier {
 public:
  using Key = NoKey;

  void clear() { stack_.clear(); }
  bool empty() const { return stack_.empty(); }
  void push(NoKey /*key*/, StateId id) { stack_.push_back(id); }

  UnorderedEntry pop() {
    const StateId id = stack_.back();
    stack_.pop_back();
    return {{}, id};
  }

 private:
  std::vector<StateId> stack_;
};

/// An open state in a frontier that orders states by key. Entries are totally ordered: the smaller key
/// first, and among equal keys the one that was pushed last. So the order of expansion does not depend
/// on the implementation of the frontier.
template <class OrderedKey>
struct FrontierEntry {
  OrderedKey key;
  std::uint32_t age_rank;  // decreases with every push
  StateId id;

  friend bool operator<(const FrontierEntry& a, const FrontierEntry& b) {
    if (a.key < b.key) return true;
    if (b.key < a.key) return false;
    return a.age_rank < b.age_rank;
  }
};

/// Open states in a heap, for keys of any kind. Push and pop take O(log n).
///
/// A state that is reached more cheaply is pushed again; the search skips the older entry when it is
/// popped (the state is closed by then).
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

  const Entry& front() const { return entries_.front(); }

  const std::vector<Entry>& entries() const { return entries_; }

  /// Removes the entries for which leaves(entry) is true, pushes others, and gives each the key key_of(id). O(n).
  template <class Leaves, class KeyOf>
  void rebuild(Leaves&& leaves, std::span<const StateId> pushed, KeyOf&& key_of) {
    std::erase_if(entries_, leaves);
    for (const StateId id : pushed) entries_.push_back({{}, age_rank_--, id});
    for (Entry& entry : entries_) entry.key = key_of(entry.id);
    min_heap::make(entries_);
  }

 private:
  std::vector<Entry> entries_;
  std::uint32_t age_rank_ = UINT32_MAX;
};

/// Open states by integer keys that never decrease (f of a consistent heuristic): a BucketQueue whose current bucket
/// is sorted.
///
/// The width of a bucket is a small part of a straight step. Most steps raise f by nothing or by more than a
/// bucket; so a state pushed into the current bucket has the smallest key there and goes to its end, where
/// pop() takes states. States are popped in exactly the order of a HeapFrontier.
///
/// Key has `f()`, an integer, and `<`. No f may be smaller than the one popped last (before the first pop, than the
/// first one pushed), nor exceed it by 255 buckets or more.
template <class OrderedKey, unsigned kBucketBits>
class BucketFrontier {
 public:
  using Key = OrderedKey;
  using Entry = FrontierEntry<Key>;

  BucketFrontier() { clear(); }

  void clear() {
    queue_.begin(Queue::kUnknown, kBucketBits);
    age_rank_ = UINT32_MAX;
  }
  bool empty() const { return queue_.empty(); }
  void push(Key key, StateId id) {
    queue_.push(static_cast<std::uint64_t>(key.f()), {key, age_rank_--, id});
  }
  Entry pop() { return queue_.pop(); }

 private:
  using Queue = BucketQueue<Entry, SmallestFirst, 256>;

  Queue queue_;
  std::uint32_t age_rank_ = UINT32_MAX;
};

}  // namespace wend
