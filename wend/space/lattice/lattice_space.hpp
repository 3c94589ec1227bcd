#pragma once

// LatticeSpace: the poses of a lattice as states of a search, numbered vertex by vertex. Steps say which steps
// are legal from a pose, in which order, and what they cost: CarSteps (car_space.hpp) or MotionSteps
// (motion_steps.hpp). Each has a companion for the smaller space of its vertices alone, for heuristics that go
// around obstacles.
//
// Steps have the types Place and Cost, kUnitsPerCell, and these functions:
//
//   lattice()                  with its columns() and rows()
//   headings()                 how many states a vertex has
//   place_at(vertex, heading)  the place, from the index of its heading
//   after(place, step)         the place to which a step leads
//   for_each(place, sink)      calls sink(step, move, cost) for every legal step
//
// Where kUndone is set, a step has a number below 16 and can be undone: way_back(place, move) is the step from
// `place` that undoes the move that led there. Otherwise searches keep parents (ParentLinks).

#include <utility>

#include "wend/base/state_id.hpp"
#include "wend/space/lattice/lattice_pose.hpp"

namespace wend {

template <class StepsType>
class LatticeSpace {
 public:
  using Steps = StepsType;
  using Place = typename Steps::Place;
  using State = BasicLatticeState<Place>;
  using Cost = typename Steps::Cost;
  static constexpr double kUnitsPerCell = Steps::kUnitsPerCell;

  /// State numbers must fit.
  explicit LatticeSpace(Steps steps)
      : steps_(std::move(steps)), columns_(static_cast<StateId>(steps_.lattice().columns())) {}

  const Steps& steps() const { return steps_; }
  const auto& lattice() const { return steps_.lattice(); }

  StateId state_count() const {
    return columns_ * static_cast<StateId>(steps_.lattice().rows()) * steps_.headings();
  }
  State state(const Place& place) const {
    const auto [x, y] = place.vertex;
    const StateId vertex = static_cast<StateId>(y) * columns_ + static_cast<StateId>(x);
    return {vertex * steps_.headings() + static_cast<StateId>(place.heading), place};
  }
  State state(StateId id) const {
    const StateId vertex = id / steps_.headings();
    const StateId y = vertex / columns_;
    const Cell cell{static_cast<int>(vertex - y * columns_), static_cast<int>(y)};
    return {id, steps_.place_at(cell, id % steps_.headings())};
  }
  StateId id(const State& state) const { return state.number; }

  State parent(const State& state, Move move) const
    requires Steps::kUndone
  {
    return after(state, steps_.way_back(state.place, move));
  }

  /// What a search probably expands next.
  StateId ahead(const State& from, const State& to) const
    requires Steps::kUndone
  {
    return 2 * to.number - from.number;
  }

  template <class Sink>
  void for_each_successor(const State& state, Move /*arrival*/, Sink&& sink) const {
    steps_.for_each(state.place, [&](const auto& step, Move move, Cost cost) {
      sink(after(state, step), move, cost);
    });
  }

 private:
  template <class Step>
  State after(const State& state, const Step& step) const {
    const Place to = Steps::after(state.place, step);
    const StateId by = static_cast<StateId>(step.by.y) * columns_ + static_cast<StateId>(step.by.x);
    return {state.number + by * steps_.headings() + static_cast<StateId>(to.heading) -
                static_cast<StateId>(state.place.heading),
            to};
  }

  Steps steps_;
  StateId columns_;
};

}  // namespace wend
