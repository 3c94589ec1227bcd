#include "wend/index/arrival_boards.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace wend {
namespace {

/// A word of a row, of the bits one place before (dx = 1) or behind (dx = -1).
std::uint64_t shifted(std::span<const std::uint64_t> words, std::size_t i, int dx) {
  return dx > 0 ? bits_before(words, i) : bits_behind(words, i);
}

/// What there is for one diagonal direction: by rows.
struct DiagonalRows {
  BitLines stops;  // beginnings, and where a step back is not legal
  BitLines met;    // the cells from which a way back meets a beginning
};

DiagonalRows diagonal_rows(const BitLines& passable, const BitLines& beginnings, Cell step) {
  const int height = passable.lines();
  DiagonalRows rows{BitLines(height, passable.length()), BitLines(height, passable.length())};
  for (int i = 0; i < height; ++i) {
    const int y = step.y > 0 ? i : height - 1 - i;  // a row after the one that steps come from
    const auto here = passable.words(y);
    const auto before = passable.words(y - step.y);
    const auto begun = beginnings.words(y - step.y);
    const auto met_before = rows.met.words(y - step.y);
    const auto own = beginnings.words(y);
    const auto met = rows.met.words(y);
    const auto stops = rows.stops.words(y);
    for (std::size_t at = 0; at < here.size(); ++at) {
      const std::uint64_t legal =
          here[at] & shifted(here, at, step.x) & before[at] & shifted(before, at, step.x);
      met[at] = legal & (shifted(begun, at, step.x) | shifted(met_before, at, step.x));
      stops[at] = own[at] | ~legal;
    }
  }
  return rows;
}

/// Puts bits of the same shape in, everywhere.
void add(BitLines& board, const BitLines& other) {
  for (int line = 0; line < board.lines(); ++line) {
    const auto words = board.words(line);
    const auto more = other.words(line);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= more[i];
  }
}

void add_blocked(BitLines& board, const BitLines& passable) {
  for (int line = 0; line < board.lines(); ++line) {
    const auto words = board.words(line);
    const auto free = passable.words(line);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= ~free[i];
  }
}

}  // namespace

ArrivalBoards::ArrivalBoards(const BitLines& rows, const BitLines& corners,
                             const Beginnings& beginnings)
    : height_(rows.lines()) {
  const BitLines columns = rows.transposed();
  std::array<BitLines, 4> met;
  for (const Direction diagonal : kDiagonalDirections) {
    const std::size_t i = quarter(diagonal);
    DiagonalRows made = diagonal_rows(rows, beginnings[i], step({0, 0}, diagonal, 1));
    diagonal_[i] = made.stops.diagonals(diagonals_along(diagonal));
    met[i] = std::move(made.met);
  }
  for (const Direction straight : kStraightDirections) {
    BitLines of_interest = corners;
    for (const Direction diagonal : beside(straight)) add(of_interest, met[quarter(diagonal)]);
    const bool vertical = straight == Direction::plus_y || straight == Direction::minus_y;
    BitLines& stops = straight_[quarter(straight)];
    stops = vertical ? of_interest.transposed() : std::move(of_interest);
    add_blocked(stops, vertical ? columns : rows);
  }
}

}  // namespace wend
