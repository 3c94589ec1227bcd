#pragma once

// Corners: the cells where shortest paths turn around obstacles, numbered row by row.
//
// Without corner cutting a corner is a passable cell with a blocked diagonal neighbour whose two
// shared orthogonal neighbours are passable. (The subgoals of T. Uras, S. Koenig and C. Hernandez,
// "Subgoal Graphs for Optimal Pathfinding in Eight-Neighbor Grids", 2013.)

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/index/index_building.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

constexpr unsigned compute_turn_sides(unsigned block) {
  const auto passable = [block](Cell at) { return (block >> (4 - 3 * at.y + at.x) & 1U) != 0; };
  unsigned sides = 0;
  for (unsigned straight = 0; straight < 4; ++straight) {
    const Cell ahead = kDirectionSteps[2 * straight];
    if (!passable({-ahead.x, -ahead.y})) continue;
    for (const unsigned turn : {1U, 3U}) {
      const Cell beside = kDirectionSteps[(2 * (straight + turn)) % kDirections];
      if (!passable(beside) || passable({beside.x - ahead.x, beside.y - ahead.y})) continue;
      sides |= (turn == 1 ? 1U : 2U) << (2 * straight);
    }
  }
  return sides;
}

inline constexpr auto kTurnSides = [] {
  std::array<std::uint8_t, 512> table{};
  for (unsigned block = 0; block < table.size(); ++block) {
    table[block] = static_cast<std::uint8_t>(compute_turn_sides(block));
  }
  return table;
}();

/// Returns 8 bits. For each straight Direction d: may a path that arrives in direction d turn to the
/// next straight direction counter-clockwise (bit d), or clockwise (bit d + 1)? `block` is
/// BitGrid::block(cell).
constexpr unsigned turn_sides(unsigned block) { return kTurnSides[block]; }

/// One bit per straight direction with at least one side: bits 0, 2, 4, 6.
constexpr unsigned turning_straights(unsigned sides) { return (sides | sides >> 1U) & 0x55U; }

/// The straight directions for which a passable cell is a jump point, where rays stop: a path that
/// arrives that way may turn. Bits as in turning_straights(). A cell is a corner if and only if there is
/// at least one.
constexpr unsigned jump_directions(unsigned block) { return turning_straights(turn_sides(block)); }

class Corners {
 public:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// O(cells). Keeps the board.
  explicit Corners(BitGrid passable, const IndexBuilding& building = {});

  const BitGrid& passable() const { return passable_; }

  std::size_t size() const { return cells_.size(); }
  Cell cell(std::uint32_t corner) const { return cells_[corner]; }

  bool contains(Cell cell) const { return bits_[cell]; }
  const BitGrid& bits() const { return bits_; }

  /// The number of a corner; kNone if the cell is not a corner. O(1).
  std::uint32_t number(Cell cell) const;

 private:
  BitGrid passable_;
  BitGrid bits_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t>
      before_;  // by word of bits_ (without the border rows): corners before it
};

/// Visits the cells on a diagonal after `from` until a step would cut a corner or is blocked, or
/// `visit(cell)` returns false.
template <class Visit>
void walk_diagonal(const BitGrid& passable, Cell from, Direction diagonal, Visit&& visit) {
  for (Cell cell = from;;) {
    const Cell next = step(cell, diagonal);
    if (!passable[{next.x, cell.y}] || !passable[{cell.x, next.y}] || !passable[next]) return;
    if (!visit(next)) return;
    cell = next;
  }
}

}  // namespace wend
