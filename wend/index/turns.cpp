#include "wend/index/turns.hpp"

#include <utility>

namespace wend {
namespace {

/// Word i of a row, shifted: the bits one place before (dx = 1) or behind (dx = -1).
std::uint64_t shifted(std::span<const std::uint64_t> words, std::size_t i, int dx) {
  return dx > 0 ? bits_before(words, i) : bits_behind(words, i);
}

/// The boards of one diagonal direction, by rows.
struct DiagonalRows {
  BitLines stops;  // beginnings, and where a step back is not legal
  BitLines met;    // the cells from which a way back meets a beginning
};

DiagonalRows diagonal_rows(const BitLines& passable, const BitLines& beginnings, Cell step) {
  const int height = passable.lines();
  DiagonalRows rows{BitLines(height, passable.length()), BitLines(height, passable.length())};
  for (int i = 0; i < height; ++i) {
    const int y = step.y > 0 ? i : height - 1 - i;  // each row after the row that steps come from
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

/// By quarter() of a diagonal: the cells where a leg along it may begin. The diagonal lies between the
/// direction of arrival at a turn and a side of the turn.
std::array<BitLines, 4> beginnings_of_legs(const Corners& corners) {
  const BitGrid& passable = corners.passable();
  std::array<BitLines, 4> beginnings;
  beginnings.fill(BitLines(passable.height(), passable.width()));
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const Cell cell = corners.cell(corner);
    const unsigned sides = turn_sides(passable.block(cell));
    for (unsigned straight = 0; straight < 4; ++straight) {
      const unsigned turning = sides >> (2 * straight);
      if ((turning & 1U) != 0) beginnings[straight].set(cell.y, cell.x);
      if ((turning & 2U) != 0) beginnings[(straight + 3) % 4].set(cell.y, cell.x);
    }
  }
  return beginnings;
}

}  // namespace

ArrivalBoards::ArrivalBoards(const Corners& corners, const JumpBoards& boards,
                             const IndexBuilding& building)
    : height_(boards.height()) {
  if (building.cancelled()) return;
  const auto beginnings = beginnings_of_legs(corners);
  std::array<BitLines, 4> met;
  for (const Direction diagonal : kDiagonalDirections) {
    if (building.cancelled()) return;
    const std::size_t i = quarter(diagonal);
    DiagonalRows made = diagonal_rows(boards.rows(), beginnings[i], step({}, diagonal));
    stops_[static_cast<std::size_t>(diagonal)] = made.stops.diagonals(diagonals_along(diagonal));
    met[i] = std::move(made.met);
  }
  const BitLines corner_rows(corners.bits());
  for (const Direction straight : kStraightDirections) {
    if (building.cancelled()) return;
    const auto [one, other] = beside(straight);
    const BitLines of_interest = mapped(corner_rows, [&](int line, std::size_t i) {
      return corner_rows.words(line)[i] | met[quarter(one)].words(line)[i] |
             met[quarter(other)].words(line)[i];
    });
    const bool vertical = straight == Direction::plus_y || straight == Direction::minus_y;
    stops_[static_cast<std::size_t>(straight)] =
        vertical ? with_blocked(of_interest.transposed(), boards.sight().columns())
                 : with_blocked(of_interest, boards.rows());
  }
}

Turns::Turns(const BitGrid& passable, const IndexBuilding& building)
    : corners_(passable, building),
      boards_(building.cancelled() ? BitGrid(1, 1) : passable),
      arrivals_(corners_, boards_, building) {
  if (building.cancelled()) return;
  first_.reserve(corners_.size());
  for (std::uint32_t corner = 0; corner < corners_.size(); ++corner) {
    const Cell cell = corners_.cell(corner);
    first_.push_back(size());
    const unsigned straights = turning_straights(sides(cell));
    for (const Direction straight : kStraightDirections) {
      if ((straights & left_side(straight)) == 0) continue;
      cells_.push_back(cell);
      straights_.push_back(straight);
    }
  }
}

}  // namespace wend
