#pragma once

// GridMoves: how a robot moves on a grid: to 4 or 8 neighbours, and what a diagonal step may pass.

#include <array>
#include <cstddef>
#include <cstdint>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/state_id.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/connected_components.hpp"

namespace wend {

/// How many neighbours a cell has.
enum class Connectivity {
  four,  // those that share an edge with it
  eight  // also those that share a corner with it
};

/// How many of the two cells beside a diagonal step may be blocked.
enum class CornerRule {
  none,  // both must be passable: no corner is cut
  one,   // one of them may be blocked
  both,  // both may be blocked: the robot squeezes between two corners
};

constexpr std::array<Choice<Connectivity>, 2> choice_names(Connectivity) {
  return {{{"4", Connectivity::four}, {"8", Connectivity::eight}}};
}

constexpr std::array<Choice<CornerRule>, 3> choice_names(CornerRule) {
  return {{{"none", CornerRule::none}, {"one", CornerRule::one}, {"both", CornerRule::both}}};
}

struct GridMoves {
  Connectivity connectivity = Connectivity::eight;  // the neighbours of a cell
  CornerRule corner_rule = CornerRule::none;        // what a diagonal step may pass

  /// Which cells such moves connect.
  Adjacency adjacency() const {
    const bool squeezes = connectivity == Connectivity::eight && corner_rule == CornerRule::both;
    return squeezes ? Adjacency::edges_and_corners : Adjacency::edges;
  }

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"connectivity", "number of neighbours of a cell: 4 or 8"}, self.connectivity);
    field({"corner_rule", "corners that a diagonal step may cut: none, one or both"},
          self.corner_rule);
  }

  friend bool operator==(const GridMoves&, const GridMoves&) = default;
};

/// Which of the eight moves are legal from a cell, looked up by the 3 x 3 block of
/// passable cells around it. Connectivity and corner rule cost nothing in the search: they only
/// change the table.
///
/// A canonical table also prunes the moves that the parent makes superfluous: the target cell can be
/// reached from the parent more cheaply without passing here, or as cheaply with the diagonal step
/// first (on 4 neighbours: the horizontal step first). On uniform terrain every cell keeps an optimal
/// path: a move is pruned for a tie only if it is the second of two and of the kind that should come
/// first. So the other path ends with a move of the other kind, and moves of that kind are never pruned
/// for a tie. (The pruning of D. Harabor and A. Grastien, "Online Graph
/// Pruning for Pathfinding on Grid Maps", 2011, without the jumps; N. Sturtevant and S. Rabin,
/// "Canonical Orderings on Grids", 2016.)
class WEND_API MoveTable {
 public:
  /// Which moves a table leaves out.
  enum class Pruning {
    none,      // only illegal moves
    longer,    // also those to cells that the parent reaches by a shorter way
    canonical  // also those to cells that it reaches by one as long, in the canonical order
  };

  /// Computes the moves for all blocks and arrivals.
  explicit MoveTable(GridMoves moves, Pruning pruning = Pruning::none);

  /// The moves from a cell that was reached by `arrival`, a Direction or kNoMove. `block` holds the
  /// passable cells of the block around it, as BitGrid::block() gives them.
  DirectionSet moves(Move arrival, unsigned block) const {
    return moves_[arrival * kBlocks + block];
  }

 private:
  static constexpr std::size_t kBlocks = 512;

  // Indexed by every value of a Move, so that a lookup needs no special case for the start.
  std::array<DirectionSet, (kNoMove + 1) * kBlocks> moves_{};
};

}  // namespace wend
