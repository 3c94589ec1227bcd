#include "wend/base/bucket_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <string>
#include <vector>

#include "wend/base/random.hpp"

namespace wend {
namespace {

struct Item {
  std::uint64_t bucket;
  int age;

  /// Is it popped later?
  friend bool operator<(const Item& a, const Item& b) {
    return a.bucket != b.bucket ? a.bucket > b.bucket : a.age < b.age;
  }
};

/// What a BucketQueue<int> of ages holds, in a heap of the standard library.
class Model {
 public:
  std::size_t size() const { return items_.size(); }
  void push(Item item) { items_.push(item); }
  Item top() const { return items_.top(); }
  Item pop() {
    const Item item = items_.top();
    items_.pop();
    return item;
  }
  std::vector<int> take_bucket() {
    std::vector<int> ages;
    const std::uint64_t bucket = top().bucket;
    while (size() > 0 && top().bucket == bucket) ages.push_back(pop().age);
    std::ranges::reverse(ages);
    return ages;
  }
  /// The age of the second one of the bucket; -1 if there is none.
  int after_next(std::uint64_t bucket) const {
    Model rest = *this;
    if (rest.size() < 2 || rest.pop().bucket != bucket || rest.top().bucket != bucket) return -1;
    return rest.top().age;
  }

 private:
  std::priority_queue<Item> items_;
};

/// How many of ten keys lie how far ahead: within a few buckets, within the window, beyond it.
struct Mix {
  int near;
  int beyond;
};

void acts_like_the_model(BucketQueue<int>& queue, Random& random, Mix mix) {
  const auto width_bits = static_cast<unsigned>(random.between(0, 10));
  std::uint64_t least = static_cast<std::uint64_t>(random.between(0, 1'000'000));
  queue.begin(least, width_bits);
  Model model;
  for (int age = 0; age < 600; ++age) {
    const int choice = random.between(0, 99);
    if (model.size() == 0 || choice < 55) {
      const int kind = random.between(0, 9);
      const int range = kind < mix.near ? 4 : kind >= 10 - mix.beyond ? 100'000 : 3000;
      const std::uint64_t key =
          least + (static_cast<std::uint64_t>(random.between(0, range)) << width_bits);
      queue.push(key, age);
      model.push({key >> width_bits, age});
    } else {
      least = model.top().bucket << width_bits;
      if (choice < 97) {
        ASSERT_EQ(queue.pop(), model.pop().age);
        const int* const after = queue.after_next();
        ASSERT_EQ(after == nullptr ? -1 : *after, model.after_next(least >> width_bits));
      } else {
        std::vector<int> taken;
        queue.take_bucket(taken);
        ASSERT_EQ(taken, model.take_bucket());
      }
      ASSERT_EQ(queue.least_key(), least);
      ASSERT_EQ(queue.end_of_bucket(), least + (std::uint64_t{1} << width_bits));
    }
    ASSERT_EQ(queue.size(), model.size());
    ASSERT_EQ(queue.empty(), model.size() == 0);
  }
}

/// Pops the lowest bucket first and in it the newest entry, whatever was pushed at any distance ahead. Not all queues
/// are empty when they begin again.
TEST(BucketQueue, PopsWhatAHeapOfBucketsPops) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    BucketQueue<int> queue;
    for (const Mix mix : {Mix{9, 0}, Mix{5, 1}, Mix{0, 0}, Mix{0, 8}}) {
      acts_like_the_model(queue, random, mix);
    }
  }
}

/// The same where keys fall, but no further than to the first bucket of the ring.
TEST(BucketQueue, FollowsFallingKeys) {
  constexpr std::uint64_t kBuckets = 4096;
  using Queue = BucketQueue<int, NewestOfFalling, kBuckets>;
  Queue queue;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto width_bits = static_cast<unsigned>(random.between(0, 10));
    const int range = random.chance(0.5) ? 50 : 6000;
    std::uint64_t first = static_cast<std::uint64_t>(random.between(0, 1'000'000));  // bucket
    std::uint64_t lowest = first;
    queue.begin(first << width_bits, width_bits);
    Model model;
    for (int age = 0; age < 2000; ++age) {
      if (model.size() == 0 || random.chance(0.52)) {
        const int ahead = random.between(-range, range);
        const std::uint64_t bucket = ahead < 0 && lowest < static_cast<std::uint64_t>(-ahead)
                                         ? 0
                                         : lowest + static_cast<std::uint64_t>(ahead);
        queue.push(bucket << width_bits, age);
        model.push({std::max(bucket, first), age});
        continue;
      }
      lowest = model.top().bucket;
      if (lowest >= first + kBuckets) first = lowest;
      ASSERT_EQ(queue.pop(), model.pop().age);
      ASSERT_EQ(queue.least_key(), lowest << width_bits);
      ASSERT_EQ(queue.size(), model.size());
    }
  }
}

}  // namespace
}  // namespace wend
