#include "wend/search/bucket_queue.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "wend/base/random.hpp"

namespace wend {
namespace {

/// Entries by key; the number of one is also its age.
using Expected = std::multimap<std::uint64_t, int>;

/// Every pop is from the lowest bucket, whatever was pushed at any distance ahead.
TEST(BucketQueue, PopsFromTheLowestBucket) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    BucketQueue<int> queue;
    for (int search = 0; search < 3; ++search) {
      const auto width_bits = static_cast<unsigned>(random.between(0, 10));
      std::uint64_t least = static_cast<std::uint64_t>(random.between(0, 1'000'000));
      queue.begin(least, width_bits);
      Expected expected;
      std::map<int, std::uint64_t> keys;
      for (int age = 0; age < 400; ++age) {
        const bool pops = !expected.empty() && random.chance(0.45);
        if (!pops) {
          const int far = random.chance(0.1) ? 100'000'000 : 3000;
          const std::uint64_t key = least + static_cast<std::uint64_t>(random.between(0, far));
          queue.push(key, age);
          expected.emplace(key, age);
          keys[age] = key;
        } else {
          const int entry = queue.pop();
          const std::uint64_t key = keys.at(entry);
          ASSERT_EQ(key >> width_bits, expected.begin()->first >> width_bits);
          ASSERT_EQ(queue.least_key(), key >> width_bits << width_bits);
          auto [at, end] = expected.equal_range(key);
          while (at != end && at->second != entry) ++at;
          ASSERT_NE(at, end) << "popped twice";
          expected.erase(at);
          least = queue.least_key();
        }
        ASSERT_EQ(queue.size(), expected.size());
        ASSERT_EQ(queue.empty(), expected.empty());
      }
    }
  }
}

TEST(BucketQueue, IsLastInFirstOutInABucket) {
  BucketQueue<int> queue;
  queue.begin(0, 4);
  for (int i = 0; i < 10; ++i) queue.push(15 - static_cast<std::uint64_t>(i), i);
  for (int i = 9; i >= 0; --i) EXPECT_EQ(queue.pop(), i);
}

}  // namespace
}  // namespace wend
