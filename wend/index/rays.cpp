#include "wend/index/rays.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wend/index/corners.hpp"

namespace wend {
namespace {

constexpr unsigned kEveryDirection = 0b1111;

bool is_vertical(Direction straight) {
  return straight == Direction::plus_y || straight == Direction::minus_y;
}

Cell transposed(Cell cell) { return {cell.y, cell.x}; }

/// The first cell after x in a row whose bit is not set. A row ends with a bit that is not.
int next_gap(std::span<const std::uint64_t> row, int x) {
  const auto bit = static_cast<std::size_t>(x + 2);  // of the cell after x
  std::size_t word = bit / 64;
  std::uint64_t gaps = ~row[word] & (~std::uint64_t{0} << (bit % 64));
  while (gaps == 0) gaps = ~row[++word];
  return static_cast<int>(64 * word) + std::countr_zero(gaps) - 1;
}

/// The last cell before x whose bit is not set. A row begins with a bit that is not.
int previous_gap(std::span<const std::uint64_t> row, int x) {
  const auto bit = static_cast<std::size_t>(x);  // of the cell before x
  std::size_t word = bit / 64;
  std::uint64_t gaps = ~row[word] & (~std::uint64_t{0} >> (63 - bit % 64));
  while (gaps == 0) gaps = ~row[--word];
  return static_cast<int>(64 * word) + 63 - std::countl_zero(gaps) - 1;
}

}  // namespace

Rays::Rays(const BitGrid& passable, Stops stops) {
  const int width = passable.width();
  const int height = passable.height();
  passing_ = {BitGrid(height, width), BitGrid(width, height), BitGrid(height, width),
              BitGrid(width, height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell cell{x, y};
      if (!passable[cell]) continue;
      const unsigned jumps = jump_directions(passable.block(cell));
      const unsigned stopping =
          stops == Stops::every_corner && jumps != 0 ? kEveryDirection : jumps;
      for (unsigned straight = 0; straight < passing_.size(); ++straight) {
        if ((stopping >> straight & 1U) != 0) continue;
        passing_[straight].set(straight % 2 == 0 ? transposed(cell) : cell, true);
      }
    }
  }
}

Cell Rays::end(Cell from, Direction straight) const {
  const BitGrid& passing = passing_[static_cast<std::size_t>(straight) / 2];
  const bool vertical = is_vertical(straight);
  const Cell begin = vertical ? transposed(from) : from;
  const bool onward = straight == Direction::plus_y || straight == Direction::plus_x;
  const auto row = passing.row_words(begin.y);
  const Cell stop{onward ? next_gap(row, begin.x) : previous_gap(row, begin.x), begin.y};
  return vertical ? transposed(stop) : stop;
}

}  // namespace wend
