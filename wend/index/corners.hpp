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
#include "wend/map/bit_grid.hpp"

namespace wend {

constexpr unsigned compute_jump_directions(unsigned block) {
  const auto passable = [block](int dx, int dy) { return (block >> (4 - 3 * dy + dx) & 1) != 0; };
  unsigned set = 0;
  for (unsigned straight = 0; straight < 4; ++straight) {
    const Cell ahead = kDirectionSteps[2 * straight];
    for (const int side : {-1, 1}) {
      const Cell beside{side * ahead.y, side * ahead.x};
      const bool jump = passable(-ahead.x, -ahead.y) && passable(beside.x, beside.y) &&
                        !passable(beside.x - ahead.x, beside.y - ahead.y);
      if (jump) set |= 1U << straight;
    }
  }
  return set;
}

inline constexpr auto kJumpDirections = [] {
  std::array<std::uint8_t, 512> table{};
  for (unsigned block = 0; block < table.size(); ++block) {
    table[block] = static_cast<std::uint8_t>(compute_jump_directions(block));
  }
  return table;
}();

/// The straight directions in which a ray stops at a passable cell as at a jump point: beside it is
/// a passable cell, and the one behind that is blocked. Bit d/2 for Direction d. `block` is
/// BitGrid::block(cell). A cell is a corner if and only if the set is not empty.
constexpr unsigned jump_directions(unsigned block) { return kJumpDirections[block]; }

class Corners {
 public:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// O(cells). Keeps the board.
  explicit Corners(BitGrid passable);

  const BitGrid& passable() const { return passable_; }

  std::size_t size() const { return cells_.size(); }
  Cell cell(std::uint32_t corner) const { return cells_[corner]; }

  bool contains(Cell cell) const { return bits_[cell]; }

  /// The number of a cell that is a corner, kNone for others. O(1).
  std::uint32_t number(Cell cell) const;

 private:
  BitGrid passable_;
  BitGrid bits_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t>
      before_;  // a word of bits_ (without the border rows): corners before it
};

}  // namespace wend
