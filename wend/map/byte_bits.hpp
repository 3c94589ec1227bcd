#pragma once

// Bits of bytes: which bytes of a row answer a question, 64 at a time, as letters and greys of a file become a row of a
// BitGrid: bits_of() for each block of for_each_block(), then set_block().

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace wend {

inline constexpr std::size_t kBlock = 64;

/// Some bytes of a block; comparing them gives Answers.
using Bytes [[gnu::vector_size(16)]] = unsigned char;
/// -1 for yes, 0 for no.
using Answers [[gnu::vector_size(16)]] = signed char;

/// A bit for each answer, on any machine.
inline std::uint64_t gathered_bits(Answers answers) {
  constexpr std::uint64_t kLowest = 0x0101010101010101U;
  constexpr std::uint64_t kGather =
      0x0102040810204080U;  // the product has bit 8 i of the factor at 56 + i
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(answers);
  return (halves[0] & kLowest) * kGather >> 56U | ((halves[1] & kLowest) * kGather >> 56U) << 8U;
}

/// The same, by the instruction that a machine has for it.
inline std::uint64_t bits_of(Answers answers) {
#if defined(__SSE2__)
  using Letters [[gnu::vector_size(16)]] = char;
  return static_cast<unsigned>(__builtin_ia32_pmovmskb128(std::bit_cast<Letters>(answers)));
#else
  return gathered_bits(answers);
#endif
}

/// A bit for each byte of a block: what `question` says of Bytes.
template <class Question>
std::uint64_t bits_of(const unsigned char* block, Question&& question) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kBlock; i += sizeof(Bytes)) {
    Bytes bytes;
    std::memcpy(&bytes, block + i, sizeof bytes);
    bits |= bits_of(static_cast<Answers>(question(bytes))) << i;
  }
  return bits;
}

/// Calls visit(x, block) for the blocks of a row; behind its end there is padding.
template <class Visit>
void for_each_block(std::span<const unsigned char> row, unsigned char padding, Visit&& visit) {
  std::size_t x = 0;
  for (; x + kBlock <= row.size(); x += kBlock) visit(x, row.data() + x);
  if (x == row.size()) return;
  std::array<unsigned char, kBlock> last;
  last.fill(padding);
  std::memcpy(last.data(), row.data() + x, row.size() - x);
  visit(x, last.data());
}

/// Sets the bits of cells from x on, a multiple of 64, in a row (BitGrid::row_words()) whose bits are false there.
inline void set_block(std::span<std::uint64_t> words, std::size_t x, std::uint64_t bits) {
  words[x / kBlock] |= bits << 1U;
  if (bits >> 63U != 0) words[x / kBlock + 1] |= 1U;
}

}  // namespace wend
