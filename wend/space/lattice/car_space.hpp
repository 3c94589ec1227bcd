#pragma once

// CarSteps: the steps of a car on a CarLattice, for LatticeSpace. CornerSteps: those between its vertices.
//
// Costs are counted in the integers of CarUnits if the terrain
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
#include "wend/space/lattice/lattice_space.hpp"

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

using CarState = BasicLatticeState<CornerPose>;

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

/// The legal moves from each pose, in the order of CarMove.
template <class CarCosts>
class CarSteps {
 public:
  using Place = CornerPose;
  using Costs = CarCosts;
  using Cost = typename Costs::Cost;
  static constexpr double kUnitsPerCell = Costs::kUnitsPerCell;
  static constexpr bool kUndone = true;
  static constexpr unsigned kAllMoves = (1U << kCarMoves) - 1;
  static constexpr unsigned kMovesAhead = 0b000111;
  static constexpr unsigned kStraightAhead = 0b000001;

  CarSteps(CarLattice lattice);  // NOLINT(google-explicit-constructor): CarSpace(lattice)

  const CarLattice& lattice() const { return lattice_; }
  static constexpr StateId headings() { return kHeadings; }

  static Place place_at(Cell vertex, StateId heading) {
    return {vertex, static_cast<Heading>(heading)};
  }
  static Place after(const Place& place, const CarStep& step) {
    return {shifted(place.vertex, step.by), step.to};
  }
  const CarStep& way_back(const Place& place, Move move) const {
    return step(place.heading, step(place.heading, static_cast<CarMove>(move)).undone_by);
  }

  template <class Sink>
  void for_each(const Place& place, Sink&& sink) const {
    for_each_of(place, kAllMoves, sink);
  }

  /// Only the moves of a set, bit m for CarMove m.
  template <class Sink>
  void for_each_of(const Place& place, unsigned moves, Sink&& sink) const {
    const Cell corner = place.vertex;
    moves &= open_[static_cast<std::size_t>(place.heading) * kBlocks + passable_->block(corner)];
    for (; moves != 0; moves &= moves - 1) {
      const auto move = static_cast<CarMove>(std::countr_zero(moves));
      const CarStep& way = step(place.heading, move);
      if (!lattice_.fits(corner, way)) continue;
      const Cost along =
          way.turns ? costs_.turn(shifted(corner, way.swept)) : straight(corner, way);
      sink(way, static_cast<Move>(move), way.reverses ? costs_.reversed(along) : along);
    }
  }

 private:
  static constexpr std::size_t kBlocks = 512;

  static Cell shifted(Cell cell, Cell by) { return {cell.x + by.x, cell.y + by.y}; }

  const CarStep& step(Heading heading, CarMove move) const { return lattice_.step(heading, move); }

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
  bool straight_pays_;
  std::array<std::uint8_t, kHeadings * kBlocks> open_{};  // moves by heading and passable block
};

using CompactCarCosts = WholeCarCosts<std::uint32_t>;
using ExactCarCosts = WholeCarCosts<std::uint64_t>;

extern template class CarSteps<CompactCarCosts>;
extern template class CarSteps<ExactCarCosts>;
extern template class CarSteps<RealCarCosts>;

template <class Costs>
using CarSpace = LatticeSpace<CarSteps<Costs>>;

/// The steps between vertices, as if the car could turn in place: it drives forwards, straight to four
/// neighbours and along arcs to four others. If reversing costs at least as much as driving ahead, their costs
/// never exceed those of the car. A move is a Direction.
template <class Costs>
class CornerSteps {
 public:
  using Car = CarSteps<Costs>;
  using Place = VertexPlace;
  using Cost = typename Costs::Cost;
  static constexpr double kUnitsPerCell = Costs::kUnitsPerCell;
  static constexpr bool kUndone = true;

  CornerSteps(Car car)  // NOLINT(google-explicit-constructor): CornerSpace(car)
      : car_(std::move(car)) {}

  const CarLattice& lattice() const { return car_.lattice(); }
  static constexpr StateId headings() { return 1; }

  static Place place_at(Cell vertex, StateId /*heading*/) { return vertex; }
  static Place after(const Place& place, const auto& step) {
    return moved(place, VertexStep{step.by});
  }
  static VertexStep way_back(const Place& /*place*/, Move move) {
    return {step({0, 0}, opposite(static_cast<Direction>(move)))};
  }

  template <class Sink>
  void for_each(const Place& from, Sink&& sink) const {
    for (const Heading heading : kAllHeadings) {
      // A car that faces along y turns to the same corners, on the other side of the cell.
      const bool all = lattice().sweeps() || is_along_x(heading);
      car_.for_each_of({from.vertex, heading}, all ? Car::kMovesAhead : Car::kStraightAhead,
                       [&](const CarStep& way, Move, Cost cost) {
                         sink(way, static_cast<Move>(direction_of(way.by)), cost);
                       });
    }
  }

 private:
  Car car_;
};

template <class Costs>
using CornerSpace = LatticeSpace<CornerSteps<Costs>>;

}  // namespace wend
