#include "wend/map/bit_grid.hpp"

#include <bit>

#include "wend/map/count_bits.hpp"

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
  other.assign_complement(*this, CellBox::of(*this));
  return other;
}

void BitGrid::assign_complement(const BitGrid& other, const CellBox& box) {
  if (box.empty()) return;
  const std::size_t end = bit_index(width_);  // of the bits of the map, which begin at 1
  const std::size_t first = bit_index(box.begin.x) / 64;
  const std::size_t last = bit_index(box.end.x - 1) / 64;
  for (int y = box.begin.y; y < box.end.y; ++y) {
    const auto words = row_words(y);
    const auto others = other.row_words(y);
    for (std::size_t i = first; i <= last; ++i) {
      std::uint64_t map = i == 0 ? ~std::uint64_t{1} : ~std::uint64_t{0};
      if (i == end / 64) map &= (std::uint64_t{1} << (end % 64)) - 1;
      words[i] = ~others[i] & map;
    }
  }
}

std::span<std::uint64_t> BitGrid::append_row() {
  append_rows(1);
  return row_words(height_ - 1);
}

void BitGrid::append_rows(int count) {
  words_.resize(words_.size() + words_per_row_ * static_cast<std::size_t>(count));
  height_ += count;
}

void BitGrid::reserve_rows(int height) {
  words_.reserve(words_per_row_ * (static_cast<std::size_t>(height) + 2) + 1);
}

std::size_t BitGrid::count() const {
  std::size_t count = 0;
  for (const std::uint64_t word : words_) count += static_cast<std::size_t>(count_bits(word));
  return count;
}

}  // namespace wend
