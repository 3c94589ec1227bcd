#include "wend/map/bit_grid.hpp"

#include <algorithm>
#include <bit>
#include <functional>

namespace wend {

// Only on little-endian machines, loads of a few bytes from the word array read neighbouring bits.
static_assert(std::endian::native == std::endian::little);

BitGrid::BitGrid(int width, int height)
    : width_(width),
      height_(height),
      words_per_row_((static_cast<std::size_t>(width) + 2 + 63) / 64),
      // One extra word, so that a load that begins in the last byte stays in bounds.
      words_(words_per_row_ * (static_cast<std::size_t>(height) + 2) + 1) {}

BitGrid BitGrid::complement() const {
  BitGrid other(width_, height_);
  const std::size_t end = bit_index(width_);  // of the bits of the map, which begin at 1
  for (int y = 0; y < height_; ++y) {
    const auto words = other.row_words(y);
    std::ranges::transform(row_words(y), words.begin(), std::bit_not<>());
    words.front() &= ~std::uint64_t{1};
    words[end / 64] &= (std::uint64_t{1} << (end % 64)) - 1;
  }
  return other;
}

std::span<std::uint64_t> BitGrid::append_row() {
  words_.resize(words_.size() + words_per_row_);
  return row_words(height_++);
}

void BitGrid::reserve_rows(int height) {
  words_.reserve(words_per_row_ * (static_cast<std::size_t>(height) + 2) + 1);
}

std::size_t BitGrid::count() const {
  std::size_t count = 0;
  for (const std::uint64_t word : words_) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

}  // namespace wend
