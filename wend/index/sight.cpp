#include "wend/index/sight.hpp"

#include <algorithm>
#include <cstdlib>

namespace wend {
namespace {

BitLines rows_of(const BitGrid& passable) {
  BitLines rows(passable.height(), passable.width());
  for (int y = 0; y < passable.height(); ++y) {
    const auto from = passable.row_words(y);
    std::copy(from.begin(), from.end(), rows.words(y).begin());
  }
  return rows;
}

/// Where a cell, its right and lower neighbours and the one between these are passable.
BitLines squares_of(const BitLines& rows) {
  BitLines squares(rows.lines(), rows.length());
  for (int y = 0; y < rows.lines(); ++y) {
    const auto upper = rows.words(y);
    const auto lower = rows.words(y + 1);
    const auto out = squares.words(y);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::uint64_t both = upper[i] & lower[i];
      const bool last = i + 1 == out.size();
      const std::uint64_t next = last ? 0 : upper[i + 1] & lower[i + 1];
      out[i] = both & (both >> 1 | next << 63);
    }
  }
  return squares;
}

}  // namespace

Sight::Sight(const BitGrid& passable)
    : height_(passable.height()), rows_(rows_of(passable)), columns_(rows_.transposed()) {
  const BitLines squares = squares_of(rows_);
  falling_right_ = squares.diagonals(BitLines::Diagonals::falling_right);
  falling_left_ = squares.diagonals(BitLines::Diagonals::falling_left);
}

bool Sight::sees(Cell from, Cell to) const {
  const int dx = to.x - from.x;
  const int dy = to.y - from.y;
  const int diagonal = std::min(std::abs(dx), std::abs(dy));
  const Cell turn{from.x + (dx < 0 ? -diagonal : diagonal),
                  from.y + (dy < 0 ? -diagonal : diagonal)};
  return diagonal_is_free(from, turn) && straight_is_free(turn, to);
}

bool Sight::diagonal_is_free(Cell from, Cell to) const {
  const int top = std::min(from.y, to.y);
  const int steps = std::abs(to.y - from.y);
  const bool falls_right = (to.x > from.x) == (to.y > from.y);
  // The squares of the steps lie on the diagonal of the upper cell, or one to the left of it.
  return falls_right ? falling_right_.all_set(from.x - from.y + height_ - 1, top, steps)
                     : falling_left_.all_set(from.x + from.y - 1, top, steps);
}

bool Sight::straight_is_free(Cell from, Cell to) const {
  return from.y == to.y
             ? rows_.all_set(from.y, std::min(from.x, to.x), std::abs(to.x - from.x) + 1)
             : columns_.all_set(from.x, std::min(from.y, to.y), std::abs(to.y - from.y) + 1);
}

}  // namespace wend
