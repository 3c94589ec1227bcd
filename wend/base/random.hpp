#pragma once

// Random numbers that are the same on every platform for the same seed (the standard library's
// distributions are not). xoshiro256** by Blackman and Vigna, seeded through splitmix64.
//
//   wend::Random random(42);
//   const int die = 1 + static_cast<int>(random.below(6));

#include <array>
#include <cstdint>

#include "wend/base/compiler.hpp"

namespace wend {

/// A generator of random numbers. One thread; copies continue with the same numbers.
class WEND_API Random {
 public:
  /// Two generators with the same seed give the same numbers.
  explicit Random(std::uint64_t seed);

  /// The next 64 random bits.
  std::uint64_t bits();

  /// A uniformly random integer in [0, bound). bound must be positive.
  std::uint64_t below(std::uint64_t bound);

  /// A uniformly random integer in [least, greatest].
  int between(int least, int greatest);

  /// A number in [0, 1).
  double uniform();

  /// A number from the normal distribution with mean 0 and standard deviation 1. It is the same on
  /// every platform, except for the last bit of logarithm and square root.
  double gaussian();

  /// True with the given probability.
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace wend
