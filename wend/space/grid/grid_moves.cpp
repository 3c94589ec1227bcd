#include "wend/space/grid/grid_moves.hpp"

#include <cstdlib>
#include <utility>

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

/// Does a path from the parent around the middle cell make the move to `target` superfluous? `ties`: also
/// if it is as long.
bool superfluous(const Neighbours& block, Offset parent, Offset target, bool ties) {
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
    if (ties && other_length == length && comes_first(first, connectivity) &&
        !comes_first(arrival, connectivity)) {
      return true;
    }
  }
  return false;
}

DirectionSet moves_in(const Neighbours& block, Move arrival, MoveTable::Pruning pruning) {
  unsigned moves = 0;
  for (int direction = 0; direction < kDirections; ++direction) {
    const Offset target = offset_of(direction);
    if (!block.legal({}, target)) continue;
    if (arrival != kNoMove && pruning != MoveTable::Pruning::none) {
      const Offset parent = Offset{} - offset_of(arrival);
      const bool ties = pruning == MoveTable::Pruning::canonical;
      if (superfluous(block, parent, target, ties)) continue;
    }
    moves |= 1U << static_cast<unsigned>(direction);
  }
  return static_cast<DirectionSet>(moves);
}

constexpr std::size_t kBlockCount = 512;
using Moves = std::array<DirectionSet, (kNoMove + 1) * kBlockCount>;

constexpr std::size_t kCornerRules = choice_names(CornerRule{}).size();
constexpr std::size_t kPrunings = 3;
constexpr std::size_t kKinds = choice_names(Connectivity{}).size() * kCornerRules * kPrunings;

std::size_t kind_of(GridMoves moves, MoveTable::Pruning pruning) {
  return (static_cast<std::size_t>(moves.connectivity) * kCornerRules +
          static_cast<std::size_t>(moves.corner_rule)) *
             kPrunings +
         static_cast<std::size_t>(pruning);
}

Moves computed_moves(std::size_t kind) {
  const auto pruning = static_cast<MoveTable::Pruning>(kind % kPrunings);
  const GridMoves rule{static_cast<Connectivity>(kind / kPrunings / kCornerRules),
                       static_cast<CornerRule>(kind / kPrunings % kCornerRules)};
  Moves moves{};
  for (unsigned block = 0; block < kBlockCount; ++block) {
    const Neighbours cells{block, rule};
    moves[kNoMove * kBlockCount + block] = moves_in(cells, kNoMove, pruning);
    for (Move arrival = 0; arrival < kDirections; ++arrival) {
      moves[arrival * kBlockCount + block] = moves_in(cells, arrival, pruning);
    }
  }
  return moves;
}

template <std::size_t kKind>
const Moves& moves_of_kind() {
  static const Moves moves = computed_moves(kKind);
  return moves;
}

/// Computed once for each kind: on a small map that takes longer than a search.
template <std::size_t... kNumbers>
const Moves& kept_moves(std::size_t kind, std::index_sequence<kNumbers...>) {
  constexpr std::array kKept{&moves_of_kind<kNumbers>...};
  return kKept[kind]();
}

}  // namespace

MoveTable::MoveTable(GridMoves moves, Pruning pruning)
    : moves_(kept_moves(kind_of(moves, pruning), std::make_index_sequence<kKinds>{})) {}

}  // namespace wend
