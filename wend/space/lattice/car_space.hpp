#pragma once

// CarSpace: the car's lattice poses are states, its six motion primitives are steps.
//
// Successors come in the order of CarMove. Costs are counted in the integers of CarUnits if the terrain
// allows it, which is exact; otherwise they are real numbers.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "wend/base/state_id.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/space/lattice/car_lattice.hpp"

namespace wend {

// Integers for the two lengths of the car's moves, 1 and pi / 2.
//
// The halves of kStraight and kTurn form a convergent of pi / 2 (33215 and 52174): sums of moves
// compare exactly like the true lengths as long as their counts of turns differ by less than 33215,
// and equal sums mean equal counts. Both are even, so that the mean of two multipliers is whole, too.

/// In 32 bits: for paths of up to some 60,000 units.
struct CarUnits {
  static constexpr std::uint32_t kStraight = 2 * 33215;
  static constexpr std::uint32_t kTurn = 2 * 52174;
};

/// A pose in lattice coordinates and its number, (y * columns + x) * 4 + heading.
struct CarState {
  StateId number = 0;
  CornerPose place{};
};

/// Can a lattice's costs be counted in CarUnits? Its multipliers are small whole numbers.
bool has_whole_costs(const CarLattice& lattice);

/// The largest multiplier that has_whole_costs() takes.
inline constexpr double kMostWholeMultiplier = 5;

/// Costs as integers of CarUnits.
template <class Unit>
class WholeCarCosts {
 public:
  using Cost = Unit;
  static constexpr double kUnitsPerCell = CarUnits::kStraight;
  static constexpr Cost kStraight = CarUnits::kStraight;
  static constexpr Cost kTurn = CarUnits::kTurn;

  explicit WholeCarCosts(const CarLattice& lattice);

  Cost turn(Cell cell) const { return terrain_.empty() ? kTurn : kTurn * terrain_[cell]; }
  Cost straight_mean(Cell a, Cell b) const {
    return kStraight / 2 * static_cast<Cost>(terrain_[a] + terrain_[b]);
  }
  Cost straight_max(Cell a, Cell b) const { return kStraight * std::max(terrain_[a], terrain_[b]); }
  Cost reversed(Cost cost) const { return cost; }

 private:
  Grid<std::uint8_t> terrain_;  // empty if uniform
};

/// Straight moves cost 1.
class RealCarCosts {
 public:
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;
  static constexpr Cost kStraight = 1;
  static constexpr Cost kTurn = kPi / 2;

  explicit RealCarCosts(const CarLattice& lattice)
      : terrain_(lattice.terrain().empty() ? nullptr : &lattice.terrain()),
        reverse_factor_(lattice.driving().reverse_factor) {}

  Cost turn(Cell cell) const { return terrain_ == nullptr ? kTurn : kTurn * (*terrain_)[cell]; }
  Cost straight_mean(Cell a, Cell b) const { return ((*terrain_)[a] + (*terrain_)[b]) / 2; }
  Cost straight_max(Cell a, Cell b) const { return std::max((*terrain_)[a], (*terrain_)[b]); }
  Cost reversed(Cost cost) const { return cost * reverse_factor_; }

 private:
  const Grid<double>* terrain_;  // of the lattice; null if uniform
  double reverse_factor_;
};

template <class Costs>
class CarSpace {
 public:
  using State = CarState;
  using Cost = typename Costs::Cost;
  using CostsType = Costs;
  static constexpr double kUnitsPerCell = Costs::kUnitsPerCell;
  static constexpr unsigned kAllMoves = (1U << kCarMoves) - 1;
  static constexpr unsigned kMovesAhead = 0b000111;
  static constexpr unsigned kStraightAhead = 0b000001;

  /// State numbers must fit: see can_number().
  explicit CarSpace(CarLattice lattice);

  /// Do the poses of a lattice fit into state numbers?
  static bool can_number(const GridMap& map, const CarDriving& driving);

  const CarLattice& lattice() const { return lattice_; }
  StateId state_count() const { return columns_ * static_cast<StateId>(lattice_.rows()) * 4; }

  State state(const CornerPose& place) const {
    const StateId corner =
        static_cast<StateId>(place.corner.y) * columns_ + static_cast<StateId>(place.corner.x);
    return {corner * 4 + static_cast<StateId>(place.heading), place};
  }
  State state(StateId id) const {
    const StateId corner = id / 4;
    const StateId y = corner / columns_;
    return {id,
            {{static_cast<int>(corner - y * columns_), static_cast<int>(y)},
             static_cast<Heading>(id % 4)}};
  }
  StateId id(const State& state) const { return state.number; }

  State parent(const State& state, Move move) const {
    const CarStep& way = step(state.place.heading, static_cast<CarMove>(move));
    return after(state, step(state.place.heading, way.undone_by));
  }

  StateId ahead(const State& from, const State& to) const { return 2 * to.number - from.number; }

  template <class Sink>
  void for_each_successor(const State& state, Move /*arrival*/, Sink&& sink) const {
    for_each_move(state, kAllMoves, sink);
  }

  /// Generates only the moves of a set, bit m for CarMove m.
  template <class Sink>
  void for_each_move(const State& state, unsigned moves, Sink&& sink) const {
    const Cell corner = state.place.corner;
    moves &=
        open_[static_cast<std::size_t>(state.place.heading) * kBlocks + passable_->block(corner)];
    for (; moves != 0; moves &= moves - 1) {
      const auto move = static_cast<CarMove>(std::countr_zero(moves));
      const CarStep& way = step(state.place.heading, move);
      if (!lattice_.fits(corner, way)) continue;
      const Cost along =
          way.turns ? costs_.turn(shifted(corner, way.swept)) : straight(corner, way);
      sink(after(state, way), static_cast<Move>(move),
           way.reverses ? costs_.reversed(along) : along);
    }
  }

 private:
  static constexpr std::size_t kBlocks = 512;

  static Cell shifted(Cell cell, Cell by) { return {cell.x + by.x, cell.y + by.y}; }

  const CarStep& step(Heading heading, CarMove move) const { return lattice_.step(heading, move); }

  State after(const State& state, const CarStep& way) const {
    const Cell corner = shifted(state.place.corner, way.by);
    return {state.number +
                (static_cast<StateId>(way.by.y) * columns_ + static_cast<StateId>(way.by.x)) * 4 +
                static_cast<StateId>(way.heading) - static_cast<StateId>(state.place.heading),
            {corner, way.heading}};
  }

  Cost straight(Cell corner, const CarStep& way) const {
    if (!straight_pays_) return Costs::kStraight;
    // Along the map's edge there is only one cell.
    Cell a = shifted(corner, way.beside);
    Cell b = shifted(corner, way.other_beside);
    if (!lattice_.terrain().contains(a)) a = b;
    if (!lattice_.terrain().contains(b)) b = a;
    return lattice_.driving().straight_terrain == StraightTerrain::max ? costs_.straight_max(a, b)
                                                                       : costs_.straight_mean(a, b);
  }

  CarLattice lattice_;
  const BitGrid* passable_;  // of the lattice
  Costs costs_;
  StateId columns_;
  bool straight_pays_;
  std::array<std::uint8_t, kHeadings * kBlocks> open_{};  // moves by heading and passable block
};

using CompactCarCosts = WholeCarCosts<std::uint32_t>;
using ExactCarCosts = WholeCarCosts<std::uint64_t>;

extern template class CarSpace<CompactCarCosts>;
extern template class CarSpace<ExactCarCosts>;
extern template class CarSpace<RealCarCosts>;

// CornerSpace: the vertices of the car's lattice are states, as if the car could turn in place: it
// drives forwards, straight to four neighbours and along arcs to four others. If reversing costs at
// least as much as driving ahead, its costs never exceed those of the car.

struct CornerState {
  StateId number = 0;
  Cell corner{};
};

template <class Costs>
class CornerSpace {
 public:
  using Car = CarSpace<Costs>;
  using State = CornerState;
  using Cost = typename Costs::Cost;

  explicit CornerSpace(Car car) : car_(std::move(car)) {}

  StateId state_count() const { return car_.state_count() / kHeadings; }

  State state(Cell corner) const {
    return {car_.state({corner, Heading::minus_y}).number / kHeadings, corner};
  }
  State state(StateId id) const { return state(car_.state(id * kHeadings).place.corner); }
  StateId id(const State& state) const { return state.number; }

  State parent(const State& state, Move move) const {
    return this->state(step(state.corner, opposite(static_cast<Direction>(move))));
  }

  StateId ahead(const State& from, const State& to) const { return 2 * to.number - from.number; }

  template <class Sink>
  void for_each_successor(const State& from, Move /*arrival*/, Sink&& sink) const {
    for (const Heading heading : kAllHeadings) {
      const CarState start = car_.state({from.corner, heading});
      // A car that faces along y turns to the same corners, on the other side of the cell.
      const bool all = car_.lattice().sweeps() || is_along_x(heading);
      const unsigned moves = all ? Car::kMovesAhead : Car::kStraightAhead;
      car_.for_each_move(start, moves, [&](const CarState& to, Move, Cost cost) {
        const Cell by{to.place.corner.x - from.corner.x, to.place.corner.y - from.corner.y};
        sink(State{to.number / kHeadings, to.place.corner}, static_cast<Move>(direction_of(by)),
             cost);
      });
    }
  }

 private:
  Car car_;
};

}  // namespace wend
