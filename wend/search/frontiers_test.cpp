// Compares the frontiers with models made of the standard library.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "wend/search/frontiers.hpp"

namespace wend {
namespace {

/// A key of two numbers; buckets use only the first.
struct PairKey {
  std::uint64_t first;
  int second;

  std::uint64_t f() const { return first; }
  friend bool operator<(const PairKey& a, const PairKey& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

constexpr unsigned kBits = 3;
constexpr std::uint64_t kTurn = 256U << kBits;
using Buckets = BucketFrontier<PairKey, kBits>;
using Heap = HeapFrontier<PairKey>;

/// Pops the smallest key, and among equal keys the one that was pushed last, by a linear scan.
class ModelFrontier {
 public:
  bool empty() const { return entries_.empty(); }
  void push(PairKey key, StateId id) { entries_.push_back({key, id}); }

  StateId pop() {
    auto best = entries_.begin();
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (!(best->key < entry->key)) best = entry;  // entries are in the order of their pushes
    }
    const StateId id = best->id;
    entries_.erase(best);
    return id;
  }

 private:
  struct Entry {
    PairKey key;
    StateId id;
  };
  std::vector<Entry> entries_;
};

/// One round of a search: pop once, then push keys that lie this far above the popped one.
struct Round {
  struct Push {
    std::uint64_t above;
    int second;
  };
  std::vector<Push> pushes;
};

/// Rounds with many ties, many empty frontiers and, sometimes, pushes far ahead.
std::vector<Round> random_rounds() {
  const auto count = *rc::gen::inRange(1, 80);
  std::vector<Round> rounds(static_cast<std::size_t>(count));
  for (Round& round : rounds) {
    const auto pushes = *rc::gen::inRange(0, 5);
    const auto range = *rc::gen::element<std::uint64_t>(1, 3, 20, kTurn - (1U << kBits));
    for (int i = 0; i < pushes; ++i) {
      round.pushes.push_back({*rc::gen::inRange<std::uint64_t>(0, range), *rc::gen::inRange(0, 3)});
    }
  }
  return rounds;
}

template <class Frontier>
void pops_like_the_model() {
  const auto base = *rc::gen::element<std::uint64_t>(0, 7, 12345, std::uint64_t{1} << 50U);
  Frontier frontier;
  ModelFrontier model;
  for (int reuse = 0; reuse < 2; ++reuse) {
    frontier.clear();
    model = {};
    StateId next_id = 0;
    std::uint64_t popped = base;
    for (const Round& round : random_rounds()) {
      RC_ASSERT(frontier.empty() == model.empty());
      if (!model.empty()) {
        const auto entry = frontier.pop();
        RC_ASSERT(entry.id == model.pop());
        popped = entry.key.f();
      } else if (next_id == 0) {  // no key is smaller than the first one
        frontier.push({base, 0}, next_id);
        model.push({base, 0}, next_id++);
      }
      for (const Round::Push& push : round.pushes) {
        frontier.push({popped + push.above, push.second}, next_id);
        model.push({popped + push.above, push.second}, next_id++);
      }
    }
    if (reuse == 1) {  // the first time it is left full
      while (!model.empty()) RC_ASSERT(frontier.pop().id == model.pop());
      RC_ASSERT(frontier.empty());
    }
  }
}

RC_GTEST_PROP(HeapFrontier, PopsTheSmallestKeyAndOfEqualOnesTheNewest, ()) {
  pops_like_the_model<Heap>();
}

RC_GTEST_PROP(BucketFrontier, PopsTheSmallestKeyAndOfEqualOnesTheNewest, ()) {
  pops_like_the_model<Buckets>();
}

/// Long runs that go through many buckets.
TEST(BucketFrontier, PopsWhatAHeapPops) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::uint32_t state = seed;
    const auto below = [&](std::uint32_t bound) {
      state = state * 1664525U + 1013904223U;
      return (state >> 8U) % bound;
    };
    Buckets buckets;
    Heap heap;
    std::uint64_t popped = 0;
    buckets.push({0, 0}, 0);
    heap.push({0, 0}, 0);
    for (StateId id = 1; id < 20'000; id += 3) {
      const std::uint32_t range = below(4) == 0 ? kTurn - (1U << kBits) : 40;
      for (StateId i = 0; i < below(5); ++i) {
        const PairKey key{popped + below(range), static_cast<int>(below(2))};
        buckets.push(key, id + i);
        heap.push(key, id + i);
      }
      ASSERT_EQ(buckets.empty(), heap.empty());
      if (heap.empty()) continue;
      const auto from_buckets = buckets.pop();
      const auto from_heap = heap.pop();
      ASSERT_EQ(from_buckets.id, from_heap.id);
      ASSERT_EQ(from_buckets.key.f(), from_heap.key.f());
      popped = from_heap.key.f();
    }
  }
}

/// Successors with keys in any order after the last state was popped (for example a start).
TEST(BucketFrontier, TakesSmallerKeysAfterLargerOnesWhenItIsEmpty) {
  Buckets buckets;
  buckets.push({1000, 0}, 1);
  EXPECT_EQ(buckets.pop().id, 1U);
  buckets.push({1900, 0}, 2);
  buckets.push({1000, 0}, 3);
  buckets.push({1500, 0}, 4);
  EXPECT_EQ(buckets.pop().id, 3U);
  EXPECT_EQ(buckets.pop().id, 4U);
  EXPECT_EQ(buckets.pop().id, 2U);
  EXPECT_TRUE(buckets.empty());
}

template <class Frontier, class Pop>
void pops_like_a_deque(const std::vector<int>& operations, Pop&& pop_model) {
  Frontier frontier;
  for (int reuse = 0; reuse < 2; ++reuse) {
    frontier.clear();
    std::deque<StateId> model;
    StateId next = 0;
    for (const int operation : operations) {
      for (int i = 0; i < operation; ++i) {
        frontier.push({}, next);
        model.push_back(next++);
      }
      RC_ASSERT(frontier.empty() == model.empty());
      if (!model.empty()) RC_ASSERT(frontier.pop().id == pop_model(model));
    }
  }
}

/// The number of pushes before each pop: enough for the ring to grow while it is wrapped around.
std::vector<int> pushes_before_pops() {
  return *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 40));
}

RC_GTEST_PROP(FifoFrontier, PopsTheOldest, ()) {
  pops_like_a_deque<FifoFrontier>(pushes_before_pops(), [](std::deque<StateId>& model) {
    const StateId id = model.front();
    model.pop_front();
    return id;
  });
}

RC_GTEST_PROP(LifoFrontier, PopsTheNewest, ()) {
  pops_like_a_deque<LifoFrontier>(pushes_before_pops(), [](std::deque<StateId>& model) {
    const StateId id = model.back();
    model.pop_back();
    return id;
  });
}

}  // namespace
}  // namespace wend
