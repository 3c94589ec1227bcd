#pragma once

// MoveTable: which of the eight moves are legal from a cell, looked up by the 3 x 3 block of
// passable cells around it. Connectivity and corner rule cost nothing in the search: they only
// make another table.
//
// A canonical table also leaves out the moves that the parent makes superfluous: where the cell
// that a move leads to can be reached from the parent more cheaply without passing here, or as
// cheaply with the diagonal step first (on 4 neighbours: the horizontal step first). On uniform
// terrain every cell keeps an optimal path: a move is left out for a tie only if it is the second
// of two, of the kind that then comes first, so the other path ends with a move of the other kind,
// and those are never left out for a tie. (The pruning of D. Harabor and A. Grastien, "Online Graph
// Pruning for Pathfinding on Grid Maps", 2011, without the jumps; N. Sturtevant and S. Rabin,
// "Canonical Orderings on Grids", 2016.)

#include <array>
#include <cstddef>
#include <cstdint>

#include "wend/base/state_id.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

class MoveTable {
 public:
  enum class Pruning { none, canonical };

  explicit MoveTable(GridMoves moves, Pruning pruning = Pruning::none);

  /// The moves from a cell that was reached by `arrival`, a Direction or kNoMove. `block` holds the
  /// passable cells of the block around it, as BitGrid::block() gives them.
  DirectionSet moves(Move arrival, unsigned block) const {
    return moves_[arrival * kBlocks + block];
  }

 private:
  static constexpr std::size_t kBlocks = 512;

  // Indexed by all that a Move can be, so that a lookup needs no case for the start.
  std::array<DirectionSet, (kNoMove + 1) * kBlocks> moves_{};
};

}  // namespace wend
