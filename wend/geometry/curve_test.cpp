#include "wend/geometry/curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

TEST(Curve, EndsAtItsGoal) {
  Random random(1);
  std::array<Curve, 48> words;
  for (int i = 0; i < 2000; ++i) {
    const Pose from{9 * random.uniform(), 9 * random.uniform(), 7 * random.uniform()};
    const Pose to{9 * random.uniform(), 9 * random.uniform(), 7 * random.uniform()};
    const int count = reeds_shepp_words(from, to, 1.5, {2, 1.2, 0.5}, kNoBound, words);
    ASSERT_GE(count, 12);
    EXPECT_EQ(words[0].cost, cheapest_reeds_shepp(from, to, 1.5, {2, 1.2, 0.5}).cost);
    for (int word = 0; word < count; ++word) {
      const Pose end = end_of(words[static_cast<std::size_t>(word)], from, 1.5);
      EXPECT_LT(distance(end.point(), to.point()), 1e-9);
      EXPECT_LT(std::abs(normalized_angle(end.heading - to.heading)), 1e-9);
    }
  }
}

}  // namespace
}  // namespace wend
