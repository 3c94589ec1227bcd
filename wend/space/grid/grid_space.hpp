#pragma once

// GridSpace: the cells of a FreeSpace as states, moves to 4 or 8 neighbours as steps.
//
// ExactGrid counts steps in whole numbers and is exact; TerrainGrid counts them in CostUnits: the length
// times the mean of the multipliers of its two cells (the L-stage additive cost of LaValle).
// DirectedGrid is the same where directions count (wend/map/direction_map.hpp), forwards or backwards.
// Successors come in the order of Direction.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "wend/base/state_id.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/direction_map.hpp"
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

/// Where a search leads.
enum class Sense : std::uint8_t {
  forwards,  // along the steps
  backwards  // against them, from the goal: a step is the one by which a path comes back
};

/// Steps that cost what terrain and directions say, in CostUnits; some are forbidden.
struct DirectedSteps {
  using Cost = std::uint64_t;
  static constexpr double kUnitsPerCell = CostUnits::kUnitsPerCell;
  static constexpr bool kDirected = true;

  /// The space has directions.
  explicit DirectedSteps(const FreeSpace& space, Sense which = Sense::forwards)
      : costs(&space.costs()), directions(space.directions()), sense(which) {}

  /// Nothing if the step is forbidden.
  std::optional<Cost> cost(const GridState& from, const GridState& to, unsigned direction) const {
    const auto leads = static_cast<Direction>(direction);
    const Direction heading = sense == Sense::forwards ? leads : opposite(leads);
    const std::uint32_t leaving = directions->factor(from.cell, heading);
    const std::uint32_t entering = directions->factor(to.cell, heading);
    if (leaving == DirectionMap::kForbidden || entering == DirectionMap::kForbidden) return {};
    const Cost sum = Cost{directed_steps(costs->steps(from.cell), leaving)} +
                     directed_steps(costs->steps(to.cell), entering);
    return sum * (is_diagonal(leads) ? CostUnits::kDiagonal : CostUnits::kStraight);
  }

  const CostMap* costs;            // owned by the FreeSpace that the space holds
  const DirectionMap* directions;  // the same
  Sense sense;
};

/// Steps that cost the same everywhere, without those that directions forbid.
struct AllowedSteps : UniformSteps<std::uint64_t> {
  static constexpr bool kDirected = true;

  explicit AllowedSteps(const FreeSpace& space, Sense which = Sense::forwards)
      : UniformSteps(space), directed(space, which), sense(which) {}

  std::optional<Cost> cost(const GridState& from, const GridState& to, unsigned direction) const {
    if (!directed.cost(from, to, direction)) return {};
    return UniformSteps::cost(from, to, (direction & 1U) != 0);
  }

  DirectedSteps directed;
  Sense sense;
};

/// Steps for which directions count.
template <class Steps>
concept IsDirected = requires { Steps::kDirected; };

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
  /// The same with directions.
  GridSpace(FreeSpace space, GridMoves moves, Sense sense)
    requires IsDirected<Steps>;

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
      if constexpr (IsDirected<Steps>) {
        const auto cost = steps_.cost(state, next, direction);
        if (cost) sink(next, static_cast<Move>(direction), *cost);
      } else {
        sink(next, static_cast<Move>(direction), steps_.cost(state, next, (direction & 1U) != 0));
      }
    }
  }

  /// What to prefetch: successors of a successor lie ahead in the same direction, at the same offset again.
  StateId ahead(const State& from, const State& to) const { return 2 * to.number - from.number; }

  /// Is there a legal step from one cell to the other? Directions are asked by may_step().
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
using DirectedGrid = GridSpace<DirectedSteps>;
using AllowedGrid = GridSpace<AllowedSteps>;

extern template class GridSpace<UniformSteps<std::uint32_t>>;
extern template class GridSpace<UniformSteps<std::uint64_t>>;
extern template class GridSpace<TerrainSteps>;
extern template class GridSpace<DirectedSteps>;
extern template class GridSpace<AllowedSteps>;

}  // namespace wend
