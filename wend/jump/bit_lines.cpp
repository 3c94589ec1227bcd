#include "wend/jump/bit_lines.hpp"

#include <algorithm>

namespace wend {
namespace {

constexpr int kBlock = 64;

/// 64 bits of a line from `at` on; zeros beyond its end, whatever the border contains.
std::uint64_t bits_at(const BitLines& board, int line, int at) {
  const auto words = board.words(line);
  const auto bit = static_cast<std::size_t>(at + 1);
  std::uint64_t bits = words[bit / kBlock] >> (bit % kBlock);
  if (bit % kBlock != 0 && bit / kBlock + 1 < words.size()) {
    bits |= words[bit / kBlock + 1] << (kBlock - bit % kBlock);
  }
  const int rest = board.length() - at;
  return rest < kBlock ? bits & ((std::uint64_t{1} << rest) - 1) : bits;
}

/// Sets bits of a line from `at` on, where they were zero.
void put_bits(std::span<std::uint64_t> words, int at, std::uint64_t bits) {
  const auto bit = static_cast<std::size_t>(at + 1);
  words[bit / kBlock] |= bits << (bit % kBlock);
  if (bit % kBlock == 0) return;
  const std::uint64_t rest = bits >> (kBlock - bit % kBlock);
  if (rest != 0) words[bit / kBlock + 1] |= rest;
}

}  // namespace

namespace {

template <unsigned kSize>
void swap_squares(BitBlock& block, std::uint64_t mask) {
  for (unsigned first = 0; first < kBlock; first += 2 * kSize) {
    for (unsigned row = first; row < first + kSize; ++row) {
      const std::uint64_t swapped = ((block[row] >> kSize) ^ block[row + kSize]) & mask;
      block[row] ^= swapped << kSize;
      block[row + kSize] ^= swapped;
    }
  }
}

}  // namespace

void transpose(BitBlock& block) {
  swap_squares<32>(block, 0x00000000FFFFFFFFU);
  swap_squares<16>(block, 0x0000FFFF0000FFFFU);
  swap_squares<8>(block, 0x00FF00FF00FF00FFU);
  swap_squares<4>(block, 0x0F0F0F0F0F0F0F0FU);
  swap_squares<2>(block, 0x3333333333333333U);
  swap_squares<1>(block, 0x5555555555555555U);
}

BitLines::BitLines(int lines, int length)
    : lines_(lines),
      length_(length),
      words_per_line_((static_cast<std::size_t>(length) + 2 + kWordBits - 1) / kWordBits),
      words_((static_cast<std::size_t>(lines) + 2) * words_per_line_ + 2 * kSlackWords) {}

BitLines::BitLines(const BitGrid& bits) : BitLines(bits.height(), bits.width()) {
  for (int y = 0; y < lines_; ++y) {
    std::copy_n(bits.row_words(y).begin(), words_per_line_, words(y).begin());
  }
}

BitLines BitLines::transposed() const {
  BitLines turned(length_, lines_);
  BitBlock block;
  for (int line = 0; line < lines_; line += kBlock) {
    for (int at = 0; at < length_; at += kBlock) {
      for (int i = 0; i < kBlock; ++i) {
        const bool inside = line + i < lines_;
        block[static_cast<std::size_t>(i)] = inside ? bits_at(*this, line + i, at) : 0;
      }
      transpose(block);
      for (int i = 0; i < std::min(kBlock, length_ - at); ++i) {
        put_bits(turned.words(at + i), line, block[static_cast<std::size_t>(i)]);
      }
    }
  }
  return turned;
}

BitLines BitLines::diagonals(Diagonals which) const {
  BitLines sheared(lines_, lines_ + length_ - 1);
  for (int line = 0; line < lines_; ++line) {
    const int shift = which == Diagonals::falling_right ? lines_ - 1 - line : line;
    for (int at = 0; at < length_; at += kBlock) {
      put_bits(sheared.words(line), at + shift, bits_at(*this, line, at));
    }
  }
  return sheared.transposed();
}

}  // namespace wend
