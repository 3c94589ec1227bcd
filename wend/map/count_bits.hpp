#pragma once

#include <bit>
#include <cstdint>

namespace wend {

/// As std::popcount(), which calls a function where the machine may lack the instruction: most words of maps are empty
/// or full.
inline int count_bits(std::uint64_t word) {
  if (word == 0) return 0;
  return ~word == 0 ? 64 : std::popcount(word);
}

}  // namespace wend
