#pragma once

// The steps of a robot on a MotionLattice, for LatticeSpace. Costs are those of MotionLattice::cost(). There are
// more steps than a move can number, so searches keep parents.

#include <algorithm>
#include <utility>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/space/lattice/lattice_space.hpp"
#include "wend/space/lattice/motion_lattice.hpp"

namespace wend {

/// From each pose, in the order of the primitives.
class MotionSteps {
 public:
  using Place = LatticePose;
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;
  static constexpr bool kUndone = false;

  MotionSteps(MotionLattice lattice)  // NOLINT(google-explicit-constructor): LatticeSpace(lattice)
      : lattice_(std::move(lattice)) {}

  const MotionLattice& lattice() const { return lattice_; }
  StateId headings() const { return static_cast<StateId>(lattice_.headings().size()); }

  static Place place_at(Cell vertex, StateId heading) {
    return {vertex, static_cast<int>(heading)};
  }
  static Place after(const Place& place, const LatticeStep& step) {
    return {{place.vertex.x + step.by.x, place.vertex.y + step.by.y}, step.to};
  }

  template <class Sink>
  void for_each(const Place& place, Sink&& sink) const {
    for (const LatticeStep& step : lattice_.leaving(place.heading)) {
      if (lattice_.fits(place.vertex, step)) sink(step, kNoMove, lattice_.cost(place.vertex, step));
    }
  }

 private:
  MotionLattice lattice_;
};

/// To each vertex from another one, as if the robot could take any heading there: with the headings gone, and
/// backwards. Costs never exceed those of the robot, so distances in this space are consistent estimates.
class VertexSteps {
 public:
  using Place = VertexPlace;
  using Cost = double;
  static constexpr double kUnitsPerCell = 1;
  static constexpr bool kUndone = false;

  VertexSteps(MotionLattice lattice)  // NOLINT(google-explicit-constructor): LatticeSpace(lattice)
      : lattice_(std::move(lattice)) {
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

  const MotionLattice& lattice() const { return lattice_; }
  static constexpr StateId headings() { return 1; }

  static Place place_at(Cell vertex, StateId /*heading*/) { return vertex; }
  static Place after(const Place& place, const VertexStep& step) { return moved(place, step); }

  template <class Sink>
  void for_each(const Place& to, Sink&& sink) const {
    const bool uniform = lattice_.free_space().uniform_terrain();
    const LatticeStep* fitted = nullptr;  // the last step that fits
    for (const LatticeStep* const step : steps_) {
      if (uniform && fitted != nullptr && fitted->by == step->by) continue;
      const VertexStep back{{-step->by.x, -step->by.y}};
      const Cell from = after(to, back).vertex;
      if (!lattice_.contains(from) || !lattice_.fits(from, *step)) continue;
      fitted = step;
      sink(back, kNoMove, lattice_.cost(from, *step));
    }
  }

 private:
  MotionLattice lattice_;  // owns the steps
  std::vector<const LatticeStep*> steps_;
};

using MotionSpace = LatticeSpace<MotionSteps>;
using VertexSpace = LatticeSpace<VertexSteps>;

}  // namespace wend
