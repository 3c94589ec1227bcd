#pragma once

// CornerSpace: the corners of a car's lattice as states, as if the car could turn on the spot: it
// goes straight to four neighbours and along arcs to four others, ahead. What that costs is never
// more than what the car pays, where reversing costs at least as much as driving ahead.

#include <cstddef>
#include <utility>

#include "wend/base/state_id.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/space/lattice/car_space.hpp"

namespace wend {

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

  template <class Sink>
  void for_each_successor(const State& from, Move /*arrival*/, Sink&& sink) const {
    for (const Heading heading : kAllHeadings) {
      const CarState start = car_.state({from.corner, heading});
      // Facing along y the car turns to the same corners, on the other side of the cell.
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
