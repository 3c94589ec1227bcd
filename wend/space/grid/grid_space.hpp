#pragma once

// GridSpace: the cells of a FreeSpace as states, moves to 4 or 8 neighbours as steps.
//
// ExactGrid counts steps in whole numbers and is exact; TerrainGrid counts them in CostUnits: the length
// times the mean of the multipliers of its two cells (the L-stage additive cost of LaValle).
// Successors come in the order of Direction.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "wend/base/state_id.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/grid_moves.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// A cell and its number, y * width + x.
struct GridState {
  StateId number = 0;
  Cell cell{};
};

/// Steps that cost the same everywhere, in OctileUnits.
template <class Unit>
struct UniformSteps {
  using Cost = Unit;
  static constexpr double kUnitsPerCell = static_cast<double>(OctileUnits<Cost>::kStraight);

  explicit UniformSteps(const FreeSpace& /*space*/) {}

  Cost cost(const GridState& /*from*/, const GridState& /*to*/, bool diagonal) const {
    return diagonal ? OctileUnits<Cost>::kDiagonal : OctileUnits<Cost>::kStraight;
  }
};

/// Steps that cost what the terrain says, in CostUnits.
struct TerrainSteps {
  using Cost = std::uint64_t;
  static constexpr double kUnitsPerCell = CostUnits::kUnitsPerCell;

  explicit TerrainSteps(const FreeSpace& space) : costs(&space.costs()) {}

  Cost cost(const GridState& from, const GridState& to, bool diagonal) const {
    const Cost sum = Cost{costs->steps(from.cell)} + costs->steps(to.cell);
    return sum * (diagonal ? CostUnits::kDiagonal : CostUnits::kStraight);
  }

  const CostMap* costs;  // owned by the FreeSpace that the space holds
};

/// Must the way along a diagonal step be checked? Without corner cutting, a disc is safe between two cells
/// where it may stand, because it may also stand on the cells beside the step. A point may touch corners.
bool sweeps_diagonals(const FreeSpace& space, GridMoves moves);

template <class Steps>
class GridSpace {
 public:
  using State = GridState;
  using Cost = typename Steps::Cost;
  static constexpr double kUnitsPerCell = Steps::kUnitsPerCell;

  /// Canonical pruning is for uniform terrain and keys that never fall along a path. It does nothing
  /// where a disc cuts corners.
  explicit GridSpace(FreeSpace space, GridMoves moves = {},
                     MoveTable::Pruning pruning = MoveTable::Pruning::none);

  /// Not between release() and update().
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access)
  const FreeSpace& free_space() const { return *space_; }
  StateId state_count() const { return static_cast<StateId>(free_space().map().size()); }

  /// Lets go of the FreeSpace. Until update() nothing else may be asked.
  void release();
  /// Takes another FreeSpace of the same size, of the same robot.
  void update(FreeSpace space);

  State state(Cell cell) const {
    return {static_cast<StateId>(cell.y) * width_ + static_cast<StateId>(cell.x), cell};
  }
  State state(StateId id) const {
    const StateId y = id / width_;
    return {id, {static_cast<int>(id - y * width_), static_cast<int>(y)}};
  }
  StateId id(const State& state) const { return state.number; }

  State parent(const State& state, Move move) const {
    return neighbour(state, static_cast<unsigned>(opposite(static_cast<Direction>(move))));
  }

  template <class Sink>
  void for_each_successor(const State& state, Move arrival, Sink&& sink) const {
    unsigned moves = moves_from(state.cell, arrival);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      const State next = neighbour(state, direction);
      sink(next, static_cast<Move>(direction), steps_.cost(state, next, (direction & 1U) != 0));
    }
  }

  /// What to prefetch: successors of a successor lie ahead in the same direction, at the same offset again.
  StateId ahead(const State& from, const State& to) const { return 2 * to.number - from.number; }

  /// Is there a legal step from one cell to the other?
  bool is_step(Cell from, Cell to) const;

 private:
  DirectionSet moves_from(Cell cell, Move arrival) const {
    const DirectionSet moves = table_.moves(arrival, passable_->block(cell));
    return sweeps_ ? without_unsafe(cell, moves) : moves;
  }

  State neighbour(const State& state, unsigned direction) const {
    const Cell offset = kDirectionSteps[direction];
    return {state.number + id_offsets_[direction],
            {state.cell.x + offset.x, state.cell.y + offset.y}};
  }

  DirectionSet without_unsafe(Cell cell, DirectionSet moves) const;

  std::optional<FreeSpace> space_;  // nothing between release() and update()
  const BitGrid* passable_;         // of the FreeSpace
  Steps steps_;
  StateId width_;
  MoveTable table_;
  bool sweeps_;  // is the way along a diagonal step to be checked?
  std::array<StateId, kDirections> id_offsets_{};  // modulo 2^32
};

using ExactGrid = GridSpace<UniformSteps<std::uint64_t>>;
using CompactGrid = GridSpace<UniformSteps<std::uint32_t>>;
using TerrainGrid = GridSpace<TerrainSteps>;

extern template class GridSpace<UniformSteps<std::uint32_t>>;
extern template class GridSpace<UniformSteps<std::uint64_t>>;
extern template class GridSpace<TerrainSteps>;

}  // namespace wend
