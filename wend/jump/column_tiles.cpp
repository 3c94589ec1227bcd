#include "wend/jump/column_tiles.hpp"

#include <algorithm>

#include "wend/jump/bit_lines.hpp"

namespace wend {
namespace {

constexpr std::size_t kSize = 64;  // of a tile

std::size_t tiles_over(int length) {
  return (static_cast<std::size_t>(length) + 2 + kSize - 1) / kSize;
}

}  // namespace

ColumnTiles::ColumnTiles(const BitGrid& bits)
    : bits_(&bits),
      line_words_(tiles_over(bits.height())),
      turned_(tiles_over(bits.width()) * line_words_),
      prepared_(turned_.size()),
      // One extra word, so that a load that begins in the last byte stays in bounds.
      words_(std::make_unique_for_overwrite<std::uint64_t[]>(kSize * turned_.size() + 1)) {}

/// Visits a tile and those around it.
template <class Visit>
void ColumnTiles::visit_around(std::size_t tile, Visit&& visit) {
  const std::size_t column = tile / line_words_;
  const std::size_t row = tile % line_words_;
  const std::size_t last_column = turned_.size() / line_words_ - 1;
  for (std::size_t i = column == 0 ? 0 : column - 1; i <= std::min(column + 1, last_column); ++i) {
    for (std::size_t j = row == 0 ? 0 : row - 1; j <= std::min(row + 1, line_words_ - 1); ++j) {
      visit(i * line_words_ + j);
    }
  }
}

void ColumnTiles::prepare_around(std::size_t tile) {
  visit_around(tile, [this](std::size_t near) {
    if (turned_[near] == 0) turn(near);
  });
  prepared_[tile] = 1;
}

void ColumnTiles::forget(const CellBox& box) {
  const auto tile_of = [](int at) { return static_cast<std::size_t>(at + 1) / kSize; };
  for (std::size_t column = tile_of(box.begin.x); column <= tile_of(box.end.x - 1); ++column) {
    for (std::size_t row = tile_of(box.begin.y); row <= tile_of(box.end.y - 1); ++row) {
      const std::size_t tile = column * line_words_ + row;
      turned_[tile] = 0;
      visit_around(tile, [this](std::size_t near) { prepared_[near] = 0; });
    }
  }
}

void ColumnTiles::turn(std::size_t tile) {
  const std::size_t column = tile / line_words_;
  const std::size_t row = tile % line_words_;
  const int top = static_cast<int>(row * kSize) - 1;  // the row of the first bit
  BitBlock block{};
  for (std::size_t i = 0; i < kSize && top + static_cast<int>(i) <= bits_->height(); ++i) {
    block[i] = bits_->row_words(top + static_cast<int>(i))[column];
  }
  transpose(block);
  std::uint64_t* word = words_.get() + column * kSize * line_words_ + row;
  for (std::size_t i = 0; i < kSize; ++i, word += line_words_) *word = block[i];
  turned_[tile] = 1;
}

}  // namespace wend
