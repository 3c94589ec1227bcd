#include "wend/base/random.hpp"

#include <bit>
#include <cassert>
#include <cmath>

namespace wend {

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) {  // splitmix64
    seed += 0x9e3779b97f4a7c15U;
    std::uint64_t mixed = seed;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebU;
    word = mixed ^ (mixed >> 31);
  }
}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

std::uint64_t Random::below(std::uint64_t bound) {
  assert(bound > 0);
  // Numbers below 2^64 mod bound would make low results more likely, so they are drawn again.
  const std::uint64_t surplus = (0 - bound) % bound;
  std::uint64_t drawn = bits();
  while (drawn < surplus) drawn = bits();
  return drawn % bound;
}

int Random::between(int least, int greatest) {
  assert(least <= greatest);
  const auto count = static_cast<std::uint64_t>(std::int64_t{greatest} - least + 1);
  return static_cast<int>(least + static_cast<std::int64_t>(below(count)));
}

double Random::gaussian() {
  // Marsaglia's polar method: from a uniformly random point in the unit disc. It also gives a second
  // number, which is not kept: the next result would depend on earlier calls.
  for (;;) {
    const double x = 2 * uniform() - 1;
    const double y = 2 * uniform() - 1;
    const double squared = x * x + y * y;
    if (squared > 0 && squared < 1) return x * std::sqrt(-2 * std::log(squared) / squared);
  }
}

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

}  // namespace wend
