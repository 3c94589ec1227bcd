#pragma once

// LatticeSpace: the poses of a robot on a MotionLattice as states of a search. VertexSpace: its vertices,
// backwards, as if the robot could take any heading at each of them. Costs are those of MotionLattice::cost().
//
// Both keep parents (ParentLinks): there are more steps than a move can number.

#include <algorithm>
#include <utility>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/space/lattice/motion_lattice.hpp"

namespace wend {

struct LatticeState {
  StateId number = 0;
  LatticePose place{};
};

class LatticeSpace {
 public:
  using State = LatticeState;
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;

  explicit LatticeSpace(MotionLattice lattice)
      : lattice_(std::move(lattice)),
        columns_(static_cast<StateId>(lattice_.columns())),
        headings_(static_cast<StateId>(lattice_.headings().size())) {}

  const MotionLattice& lattice() const { return lattice_; }

  StateId state_count() const {
    return columns_ * static_cast<StateId>(lattice_.rows()) * headings_;
  }
  State state(const LatticePose& place) const {
    const auto [x, y] = place.vertex;
    const StateId vertex = static_cast<StateId>(y) * columns_ + static_cast<StateId>(x);
    return {vertex * headings_ + static_cast<StateId>(place.heading), place};
  }
  State state(StateId id) const {
    const StateId vertex = id / headings_;
    return {id,
            {{static_cast<int>(vertex % columns_), static_cast<int>(vertex / columns_)},
             static_cast<int>(id % headings_)}};
  }
  StateId id(const State& state) const { return state.number; }

  template <class Sink>
  void for_each_successor(const State& from, Move /*arrival*/, Sink&& sink) const {
    const Cell vertex = from.place.vertex;
    for (const LatticeStep& step : lattice_.leaving(from.place.heading)) {
      if (!lattice_.fits(vertex, step)) continue;
      const LatticePose to{{vertex.x + step.by.x, vertex.y + step.by.y}, step.to};
      sink(state(to), kNoMove, lattice_.cost(vertex, step));
    }
  }

 private:
  MotionLattice lattice_;
  StateId columns_;
  StateId headings_;
};

struct VertexState {
  StateId number = 0;
  Cell vertex{};
};

/// A successor is a vertex from which a step, with any heading, leads here. Costs never exceed those of
/// the robot, so distances in this space are consistent estimates.
class VertexSpace {
 public:
  using State = VertexState;
  using Cost = double;

  explicit VertexSpace(MotionLattice lattice)
      : lattice_(std::move(lattice)), columns_(static_cast<StateId>(lattice_.columns())) {
    for (const LatticeStep& step : lattice_.steps()) {
      if (!(step.by == Cell{0, 0})) steps_.push_back(&step);
    }
    // Steps that lead equally far, the cheapest first.
    std::ranges::sort(steps_, [](const LatticeStep* a, const LatticeStep* b) {
      if (a->by.x != b->by.x) return a->by.x < b->by.x;
      if (a->by.y != b->by.y) return a->by.y < b->by.y;
      return a->cost < b->cost;
    });
  }

  StateId state_count() const { return columns_ * static_cast<StateId>(lattice_.rows()); }
  State state(Cell vertex) const {
    return {static_cast<StateId>(vertex.y) * columns_ + static_cast<StateId>(vertex.x), vertex};
  }
  State state(StateId id) const {
    return {id, {static_cast<int>(id % columns_), static_cast<int>(id / columns_)}};
  }
  StateId id(const State& state) const { return state.number; }

  template <class Sink>
  void for_each_successor(const State& to, Move /*arrival*/, Sink&& sink) const {
    const bool uniform = lattice_.free_space().uniform_terrain();
    const LatticeStep* fitted = nullptr;  // the last step that fits
    for (const LatticeStep* const step : steps_) {
      if (uniform && fitted != nullptr && fitted->by == step->by) continue;
      const Cell from{to.vertex.x - step->by.x, to.vertex.y - step->by.y};
      if (!lattice_.contains(from) || !lattice_.fits(from, *step)) continue;
      fitted = step;
      sink(state(from), kNoMove, lattice_.cost(from, *step));
    }
  }

 private:
  MotionLattice lattice_;  // owns the steps
  StateId columns_;
  std::vector<const LatticeStep*> steps_;
};

}  // namespace wend
