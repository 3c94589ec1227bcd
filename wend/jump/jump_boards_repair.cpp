// The bits of JumpBoards that an edit changes, cell by cell. What a bit says is defined in jump_boards.cpp.

#include <vector>

#include "wend/jump/jump_boards.hpp"

namespace wend {
namespace {

/// Calls visit(cell) for the cells of a box.
template <class Visit>
void for_each_cell(const CellBox& box, Visit&& visit) {
  for (int y = box.begin.y; y < box.end.y; ++y) {
    for (int x = box.begin.x; x < box.end.x; ++x) visit(Cell{x, y});
  }
}

/// The last cell of a box in a direction, on the line of a cell.
Cell last_in(const CellBox& box, Direction straight, Cell on_line) {
  using enum Direction;
  switch (straight) {
    case plus_x:
      return {box.end.x - 1, on_line.y};
    case minus_x:
      return {box.begin.x, on_line.y};
    case plus_y:
      return {on_line.x, box.end.y - 1};
    default:
      return {on_line.x, box.begin.y};
  }
}

}  // namespace

void Sight::repair(const BitGrid& passable, const CellBox& box) {
  for_each_cell(box, [&](Cell cell) {
    rows_.assign(cell.y, cell.x, passable[cell]);
    columns_.assign(cell.x, cell.y, passable[cell]);
  });
  const CellBox squares = CellBox{{box.begin.x - 1, box.begin.y - 1}, box.end}.clipped_to(passable);
  for_each_cell(squares, [&](Cell cell) {
    const bool free = passable[cell] && passable[{cell.x + 1, cell.y}] &&
                      passable[{cell.x, cell.y + 1}] && passable[{cell.x + 1, cell.y + 1}];
    using enum BitLines::Diagonals;
    falling_right_.assign(diagonal_line(falling_right, cell, rows_.lines()), cell.y, free);
    falling_left_.assign(diagonal_line(falling_left, cell, rows_.lines()), cell.y, free);
  });
}

bool JumpBoards::is_jump_point(Direction ahead, Cell cell) const {
  const Cell last = step(cell, ahead, -1);
  if (!passable(cell) || !passable(last)) return false;
  for (const int eighths : {2, -2}) {
    const Direction side = turned(ahead, eighths);
    if (passable(step(cell, side, 1)) && !passable(step(last, side, 1))) return true;
  }
  return false;
}

bool JumpBoards::is_jump_point(Cell cell) const {
  for (const Direction ahead : kStraightDirections) {
    if (is_jump_point(ahead, cell)) return true;
  }
  return false;
}

bool JumpBoards::is_legal(Direction diagonal, Cell cell) const {
  const auto [one, other] = beside(diagonal);
  return passable(cell) && passable(step(cell, one, 1)) && passable(step(cell, other, 1)) &&
         passable(step(cell, diagonal, 1));
}

bool JumpBoards::stops_at(Direction direction, Cell cell) const {
  const auto [line, at] = line_place(direction, cell, height());
  return stops_[static_cast<std::size_t>(direction)].get(line, at);
}

void JumpBoards::set_stop(Direction direction, Cell cell, bool stops) {
  const auto [line, at] = line_place(direction, cell, height());
  stops_[static_cast<std::size_t>(direction)].assign(line, at, stops);
}

void JumpBoards::set_move(Direction direction, Cell cell, bool moves) {
  const DirectionSet without = moves_[cell] & static_cast<DirectionSet>(~set_of(direction));
  moves_[cell] = static_cast<DirectionSet>(without | (moves ? set_of(direction) : 0));
}

/// Follows each line of cells through the box back to the last stop before it: rays of the cells behind that
/// one end there. Appends the cells whose ray has changed.
void JumpBoards::repair_rays(Direction ahead, const CellBox& around, std::vector<Cell>& changed) {
  const bool along_x = ahead == Direction::plus_x || ahead == Direction::minus_x;
  const int lines = along_x ? around.height() : around.width();
  for (int i = 0; i < lines; ++i) {
    const Cell on_line = along_x ? Cell{around.begin.x, around.begin.y + i}
                                 : Cell{around.begin.x + i, around.begin.y};
    Cell at = last_in(around, ahead, on_line);
    const auto [line, place] = line_place(ahead, at, height());
    const BitLines& stops = stops_[static_cast<std::size_t>(ahead)];
    const int steps =
        leads_ahead(ahead) ? stops.distance_ahead(line, place) : stops.distance_back(line, place);
    bool jumps = passable(step(at, ahead, steps));  // is the next stop a jump point?
    for (; at.x >= 0 && at.y >= 0 && at.x < width() && at.y < height(); at = step(at, ahead, -1)) {
      if (((moves_[at] & set_of(ahead)) != 0) != jumps) {
        set_move(ahead, at, jumps);
        changed.push_back(at);
      }
      if (!stops_at(ahead, at)) continue;
      if (!around.contains(at)) break;
      jumps = passable(at);
    }
  }
}

void JumpBoards::repair_diagonal_stops(Cell cell) {
  const DirectionSet moves = moves_[cell];
  for (const Direction diagonal : kDiagonalDirections) {
    const auto [one, other] = beside(diagonal);
    const bool ray = (moves & (set_of(one) | set_of(other))) != 0;
    set_stop(diagonal, cell, ray || (moves & set_of(diagonal)) == 0);
  }
}

void JumpBoards::repair(const BitGrid& passable_cells, std::span<const CellBox> boxes) {
  std::vector<CellBox> around;  // each box: where jump points and legal steps may have changed
  for (const CellBox& box : boxes) {
    sight_.repair(passable_cells, box);
    around.push_back(box.grown_by(1).clipped_to(passable_cells));
  }
  std::vector<Cell> changed;
  for (const CellBox& box : around) {
    for_each_cell(box, [&](Cell cell) {
      for (const Direction ahead : kStraightDirections) {
        set_stop(ahead, cell, !passable(cell) || is_jump_point(ahead, cell));
      }
      for (const Direction diagonal : kDiagonalDirections) {
        set_move(diagonal, cell, is_legal(diagonal, cell));
      }
      changed.push_back(cell);
    });
  }
  for (const CellBox& box : around) {
    for (const Direction ahead : kStraightDirections) repair_rays(ahead, box, changed);
  }
  for (const Cell cell : changed) repair_diagonal_stops(cell);
}

}  // namespace wend
