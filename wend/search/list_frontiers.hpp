#pragma once

// FifoFrontier and LifoFrontier: open states by order of arrival. O(1) a push and a pop.

#include <cstddef>
#include <vector>

#include "wend/base/state_id.hpp"

namespace wend {

/// Where states are not ordered by key.
struct NoKey {};

struct UnorderedEntry {
  NoKey key;
  StateId id;
};

/// First in, first out: a ring that doubles when it is full.
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

/// Last in, first out.
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

}  // namespace wend
