#include "wend/index/turns.hpp"

#include <cstdint>

namespace wend {
namespace {

/// Where legs begin, by the diagonal between each straight direction and the next.
ArrivalBoards arrival_boards(const Corners& corners, const JumpBoards& boards) {
  const BitGrid& passable = corners.passable();
  const BitLines none(passable.height(), passable.width());
  BitLines rows = none;
  ArrivalBoards::Beginnings beginnings{none, none, none, none};
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const Cell cell = corners.cell(corner);
    const unsigned sides = turn_sides(passable.block(cell));
    rows.set(cell.y, cell.x);
    for (unsigned straight = 0; straight < 4; ++straight) {
      const unsigned turning = sides >> (2 * straight);
      if ((turning & 1U) != 0) beginnings[straight].set(cell.y, cell.x);
      if ((turning & 2U) != 0) beginnings[(straight + 3) % 4].set(cell.y, cell.x);
    }
  }
  return {boards.rows(), rows, beginnings};
}

}  // namespace

Turns::Turns(const BitGrid& passable)
    : corners_(passable), boards_(passable), arrivals_(arrival_boards(corners_, boards_)) {
  using enum Direction;
  first_.reserve(corners_.size());
  for (std::uint32_t corner = 0; corner < corners_.size(); ++corner) {
    const Cell cell = corners_.cell(corner);
    first_.push_back(size());
    const unsigned straights = turning_straights(sides(cell));
    for (const Direction straight : {plus_y, plus_x, minus_y, minus_x}) {
      if ((straights & left_side(straight)) == 0) continue;
      cells_.push_back(cell);
      straights_.push_back(straight);
    }
  }
}

}  // namespace wend
