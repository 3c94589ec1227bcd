#include "wend/jump/sight.hpp"

#include <algorithm>
#include <cstdlib>

#include "wend/space/grid/octile_way.hpp"

namespace wend {
namespace {

using enum BitLines::Diagonals;

/// Where a cell, its right and lower neighbours and the one between these are passable.
BitLines squares_of(const BitLines& rows) {
  BitLines squares(rows.lines(), rows.length());
  for (int y = 0; y < rows.lines(); ++y) {
    const auto upper = rows.words(y);
    const auto lower = rows.words(y + 1);
    const auto out = squares.words(y);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = upper[i] & bits_behind(upper, i) & lower[i] & bits_behind(lower, i);
    }
  }
  return squares;
}

}  // namespace

Sight::Sight(const BitGrid& passable) : rows_(passable), columns_(rows_.transposed()) {
  const BitLines squares = squares_of(rows_);
  falling_right_ = squares.diagonals(falling_right);
  falling_left_ = squares.diagonals(falling_left);
}

bool Sight::sees(Cell from, Cell to) const {
  const Cell bend = octile_bend(from, to);
  // Most ways that are not free fail in their straight part, which is read faster.
  return straight_is_free(bend, to) && diagonal_is_free(from, bend);
}

bool Sight::diagonal_is_free(Cell from, Cell to) const {
  if (from == to) return true;
  const int steps = std::abs(to.y - from.y);
  const Cell top = from.y < to.y ? from : to;
  if ((to.x > from.x) == (to.y > from.y)) {
    return falling_right_.all_set(diagonal_line(falling_right, top, rows_.lines()), top.y, steps);
  }
  const Cell square{top.x - 1, top.y};  // of its first step
  return falling_left_.all_set(diagonal_line(falling_left, square, rows_.lines()), top.y, steps);
}

bool Sight::straight_is_free(Cell from, Cell to) const {
  return from.x == to.x
             ? columns_.all_set(from.x, std::min(from.y, to.y), std::abs(to.y - from.y) + 1)
             : rows_.all_set(from.y, std::min(from.x, to.x), std::abs(to.x - from.x) + 1);
}

}  // namespace wend
