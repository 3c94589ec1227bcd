#include "wend/jump/column_tiles.hpp"

#include "wend/jump/bit_lines.hpp"

namespace wend {
namespace {

std::size_t tiles_over(int length) { return (static_cast<std::size_t>(length) + 2 + 63) / 64; }

}  // namespace

ColumnTiles::ColumnTiles(const BitGrid& bits)
    : bits_(&bits),
      tile_rows_(tiles_over(bits.height())),
      turned_(tiles_over(bits.width()) * tile_rows_),
      words_(std::make_unique_for_overwrite<std::uint64_t[]>(64 * turned_.size())) {}

void ColumnTiles::turn(std::size_t tile) {
  const std::size_t word = tile / tile_rows_;
  const int top = static_cast<int>(tile % tile_rows_) * 64 - 1;  // the row of the first bit
  BitBlock block{};
  for (int i = 0; i < 64 && top + i <= bits_->height(); ++i) {
    block[static_cast<std::size_t>(i)] = bits_->row_words(top + i)[word];
  }
  transpose(block);
  std::copy(block.begin(), block.end(), words_.get() + 64 * tile);
  turned_[tile] = 1;
}

}  // namespace wend
