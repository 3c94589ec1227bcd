#include "wend/space/grid/grid_moves.hpp"

#include <cstdlib>

namespace wend {
namespace {

using Offset = Cell;

constexpr Offset operator+(Offset a, Offset b) { return {a.x + b.x, a.y + b.y}; }
constexpr Offset operator-(Offset a, Offset b) { return {a.x - b.x, a.y - b.y}; }

constexpr Offset offset_of(int direction) {
  return kDirectionSteps[static_cast<std::size_t>(direction)];
}

/// The 3 x 3 block around a cell, which decides which moves are legal.
struct Neighbours {
  unsigned passable_bits;
  GridMoves rule;

  bool passable(Offset at) const {
    if (std::abs(at.x) > 1 || std::abs(at.y) > 1) return false;
    const auto bit = static_cast<unsigned>((1 - at.y) * 3 + at.x + 1);
    return ((passable_bits >> bit) & 1U) != 0;
  }

  /// Is the step between two neighbouring cells of the block legal?
  bool legal(Offset from, Offset to) const {
    if (!passable(from) || !passable(to)) return false;
    const Offset step = to - from;
    if (std::abs(step.x) + std::abs(step.y) == 1) return true;
    if (rule.connectivity == Connectivity::four) return false;
    const int blocked = static_cast<int>(!passable({from.x + step.x, from.y})) +
                        static_cast<int>(!passable({from.x, from.y + step.y}));
    switch (rule.corner_rule) {
      case CornerRule::none:
        return blocked == 0;
      case CornerRule::one:
        return blocked <= 1;
      case CornerRule::both:
        return true;
    }
    return false;
  }
};

bool is_neighbour(Offset step) {
  return step != Offset{} && std::abs(step.x) <= 1 && std::abs(step.y) <= 1;
}

bool is_diagonal_step(Offset step) { return step.x != 0 && step.y != 0; }

/// The kind of step that comes first in a canonical path of equal steps.
bool comes_first(Offset step, Connectivity connectivity) {
  return connectivity == Connectivity::eight ? is_diagonal_step(step) : step.y == 0;
}

/// Ranks the length of at most two steps: one step before two, and among equal numbers of steps those
/// with fewer diagonals.
int length_rank(Offset first, Offset second) {
  const int steps = static_cast<int>(first != Offset{}) + static_cast<int>(second != Offset{});
  const int diagonals =
      static_cast<int>(is_diagonal_step(first)) + static_cast<int>(is_diagonal_step(second));
  return 3 * steps + diagonals;
}

/// Does a path from the parent around the middle cell make the move to `target` superfluous?
bool superfluous(const Neighbours& block, Offset parent, Offset target) {
  if (target == parent) return true;
  const Offset arrival = Offset{} - parent;
  const int length = length_rank(arrival, target);
  if (is_neighbour(target - parent) && block.legal(parent, target)) return true;
  for (int direction = 0; direction < kDirections; ++direction) {
    const Offset first = offset_of(direction);
    const Offset via = parent + first;
    const Offset second = target - via;
    if (via == Offset{} || !is_neighbour(second)) continue;
    if (!block.legal(parent, via) || !block.legal(via, target)) continue;
    const int other_length = length_rank(first, second);
    if (other_length < length) return true;
    const Connectivity connectivity = block.rule.connectivity;
    if (other_length == length && comes_first(first, connectivity) &&
        !comes_first(arrival, connectivity)) {
      return true;
    }
  }
  return false;
}

DirectionSet moves_in(const Neighbours& block, Move arrival) {
  unsigned moves = 0;
  for (int direction = 0; direction < kDirections; ++direction) {
    const Offset target = offset_of(direction);
    if (!block.legal({}, target)) continue;
    if (arrival != kNoMove) {
      const Offset parent = Offset{} - offset_of(arrival);
      if (superfluous(block, parent, target)) continue;
    }
    moves |= 1U << static_cast<unsigned>(direction);
  }
  return static_cast<DirectionSet>(moves);
}

}  // namespace

MoveTable::MoveTable(GridMoves moves, Pruning pruning) {
  for (unsigned block = 0; block < kBlocks; ++block) {
    const Neighbours cells{block, moves};
    moves_[kNoMove * kBlocks + block] = moves_in(cells, kNoMove);
    for (Move arrival = 0; arrival < kDirections; ++arrival) {
      const Move judged = pruning == Pruning::canonical ? arrival : kNoMove;
      moves_[arrival * kBlocks + block] = moves_in(cells, judged);
    }
  }
}

}  // namespace wend
