#include "wend/base/random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace wend {
namespace {

/// A second implementation of xoshiro256** and splitmix64, written from the text of their papers.
class Reference {
 public:
  explicit Reference(std::uint64_t seed) {
    for (auto* const word : {&a_, &b_, &c_, &d_}) {
      seed += 11400714819323198485U;
      std::uint64_t z = seed;
      z ^= z >> 30;
      z *= 13787848793156543929U;
      z ^= z >> 27;
      z *= 10723151780598845931U;
      z ^= z >> 31;
      *word = z;
    }
  }

  std::uint64_t next() {
    const std::uint64_t five = (b_ << 2) + b_;
    const std::uint64_t turned = (five << 7) | (five >> 57);
    const std::uint64_t result = (turned << 3) + turned;
    const std::uint64_t c = c_ ^ a_;
    const std::uint64_t d = d_ ^ b_;
    const std::uint64_t shifted = b_ << 17;
    b_ ^= c;
    a_ ^= d;
    c_ = c ^ shifted;
    d_ = (d << 45) | (d >> 19);
    return result;
  }

 private:
  std::uint64_t a_ = 0;
  std::uint64_t b_ = 0;
  std::uint64_t c_ = 0;
  std::uint64_t d_ = 0;
};

RC_GTEST_PROP(Random, IsXoshiro256StarStarSeededBySplitmix64, (std::uint64_t seed)) {
  Random random(seed);
  Reference reference(seed);
  for (int i = 0; i < 50; ++i) RC_ASSERT(random.bits() == reference.next());
}

TEST(Random, GivesTheSameOnEveryPlatform) {
  // These must never change: golden files and generated maps depend on them.
  Random random(42);
  EXPECT_EQ(random.bits(), 1546998764402558742U);
  EXPECT_EQ(random.bits(), 6990951692964543102U);
  EXPECT_EQ(random.bits(), 12544586762248559009U);
}

RC_GTEST_PROP(Random, TheSameSeedGivesTheSameNumbersAndAnotherOneOthers, (std::uint64_t seed)) {
  Random one(seed);
  Random same(seed);
  Random other(seed + 1);
  int equal_to_other = 0;
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t bits = one.bits();
    RC_ASSERT(same.bits() == bits);
    equal_to_other += other.bits() == bits ? 1 : 0;
  }
  RC_ASSERT(equal_to_other == 0);
}

RC_GTEST_PROP(Random, BelowStaysInRange, (std::uint64_t seed, std::uint64_t bound)) {
  RC_PRE(bound > 0);
  Random random(seed);
  for (int i = 0; i < 20; ++i) RC_ASSERT(random.below(bound) < bound);
  RC_ASSERT(random.below(1) == 0);
}

RC_GTEST_PROP(Random, BetweenStaysInRange, (std::uint64_t seed, int a, int b)) {
  Random random(seed);
  const int least = std::min(a, b);
  const int greatest = std::max(a, b);
  for (int i = 0; i < 20; ++i) {
    const int drawn = random.between(least, greatest);
    RC_ASSERT(drawn >= least);
    RC_ASSERT(drawn <= greatest);
  }
  RC_ASSERT(random.between(a, a) == a);
}

TEST(Random, BetweenTakesTheWholeRangeOfInt) {
  Random random(1);
  bool negative = false;
  bool positive = false;
  for (int i = 0; i < 100; ++i) {
    const int drawn = random.between(INT32_MIN, INT32_MAX);
    (drawn < 0 ? negative : positive) = true;
  }
  EXPECT_TRUE(negative);
  EXPECT_TRUE(positive);
}

TEST(Random, BelowDrawsEveryNumberEquallyOften) {
  constexpr int kDraws = 100000;
  for (const std::uint64_t bound : {2U, 3U, 6U, 7U, 10U}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      SCOPED_TRACE(testing::Message() << "bound " << bound << ", seed " << seed);
      Random random(seed);
      std::vector<int> drawn(bound, 0);
      for (int i = 0; i < kDraws; ++i) ++drawn[random.below(bound)];
      const double expected = static_cast<double>(kDraws) / static_cast<double>(bound);
      for (const int count : drawn) EXPECT_NEAR(count, expected, 5 * std::sqrt(expected));
    }
  }
}

TEST(Random, BelowIsUnbiasedWhereTheBoundDoesNotDivideTheRange) {
  // A plain remainder, without rejection, would give the lower half twice as often as the upper one.
  const std::uint64_t bound = (std::uint64_t{1} << 63) + (std::uint64_t{1} << 62);
  Random random(7);
  int lower_third = 0;
  for (int i = 0; i < 30000; ++i) lower_third += random.below(bound) < bound / 3 ? 1 : 0;
  EXPECT_NEAR(lower_third, 10000, 400);
}

TEST(Random, UniformFillsTheUnitInterval) {
  Random random(5);
  double sum = 0;
  double least = 1;
  double greatest = 0;
  for (int i = 0; i < 100000; ++i) {
    const double drawn = random.uniform();
    ASSERT_GE(drawn, 0);
    ASSERT_LT(drawn, 1);
    sum += drawn;
    least = std::fmin(least, drawn);
    greatest = std::fmax(greatest, drawn);
  }
  EXPECT_NEAR(sum / 100000, 0.5, 0.005);
  EXPECT_LT(least, 0.001);
  EXPECT_GT(greatest, 0.999);
}

TEST(Random, ChanceComesAsOftenAsItSays) {
  Random random(6);
  int hits = 0;
  for (int i = 0; i < 100000; ++i) {
    EXPECT_FALSE(random.chance(0));
    EXPECT_TRUE(random.chance(1));
    hits += random.chance(0.2) ? 1 : 0;
  }
  EXPECT_NEAR(hits, 20000, 700);
}

TEST(Random, GaussianHasTheNormalDistribution) {
  // How many of 100000 lie below each number, by tables of the normal distribution.
  constexpr std::array<std::pair<double, double>, 7> kBelow{
      {{-2, 2275}, {-1, 15866}, {-0.5, 30854}, {0, 50000}, {0.5, 69146}, {1, 84134}, {2, 97725}}};
  Random random(8);
  std::vector<double> drawn(100000);
  for (double& number : drawn) number = random.gaussian();
  for (const auto& [bound, expected] : kBelow) {
    const auto below = std::count_if(drawn.begin(), drawn.end(),
                                     [bound = bound](double number) { return number < bound; });
    EXPECT_NEAR(static_cast<double>(below), expected, 700) << "below " << bound;
  }
}

TEST(Random, GaussianIsAFunctionOfTheSeed) {
  Random random(9);
  Random same(9);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random.gaussian(), same.gaussian());
}

}  // namespace
}  // namespace wend
