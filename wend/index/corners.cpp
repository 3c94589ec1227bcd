#include "wend/index/corners.hpp"

#include <bit>
#include <utility>

namespace wend {
namespace {

std::size_t word_of(const BitGrid& bits, Cell cell) {
  return static_cast<std::size_t>(cell.y) * bits.row_words(0).size() +
         static_cast<std::size_t>(cell.x + 1) / 64;
}

}  // namespace

Corners::Corners(BitGrid passable, const IndexBuilding& building)
    : passable_(std::move(passable)), bits_(passable_.width(), passable_.height()) {
  for (int y = 0; y < passable_.height() && !building.cancelled(); ++y) {
    for (int x = 0; x < passable_.width(); ++x) {
      const Cell cell{x, y};
      if (!passable_[cell] || jump_directions(passable_.block(cell)) == 0) continue;
      bits_.set(cell, true);
      cells_.push_back(cell);
    }
  }
  std::uint32_t before = 0;
  for (int y = 0; y < passable_.height(); ++y) {
    for (const std::uint64_t word : bits_.row_words(y)) {
      before_.push_back(before);
      before += static_cast<std::uint32_t>(std::popcount(word));
    }
  }
}

std::uint32_t Corners::number(Cell cell) const {
  const auto bit = static_cast<std::size_t>(cell.x + 1);
  const std::uint64_t word = bits_.row_words(cell.y)[bit / 64];
  const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
  if ((word & mask) == 0) return kNone;
  return before_[word_of(bits_, cell)] +
         static_cast<std::uint32_t>(std::popcount(word & (mask - 1)));
}

}  // namespace wend
