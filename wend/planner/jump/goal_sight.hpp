#pragma once

// GoalSight: the goals of a jump point search, and the cheapest path to one of them found so far.
//
//   goals.begin(regions, start, boards);
//   const auto view = goals.look(jumps, cell, directions, g);
//   if (view.nearest) ...  // no need to go on from there
//
// Costs are in OctileUnits<Cost>.

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/planner/goal_cells.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// The first direction of the path to a cell that takes its diagonal steps first; none for the cell
/// itself.
constexpr DirectionSet first_direction(Cell from, Cell to) {
  using enum Direction;
  constexpr std::array<DirectionSet, 9> kByNeighbour{set_of(minus_x_minus_y),
                                                     set_of(minus_y),
                                                     set_of(plus_x_minus_y),
                                                     set_of(minus_x),
                                                     0,
                                                     set_of(plus_x),
                                                     set_of(minus_x_plus_y),
                                                     set_of(plus_y),
                                                     set_of(plus_x_plus_y)};
  const int right_of = static_cast<int>(to.x > from.x) - static_cast<int>(to.x < from.x);
  const int below = static_cast<int>(to.y > from.y) - static_cast<int>(to.y < from.y);
  return kByNeighbour[static_cast<std::size_t>(4 + 3 * below + right_of)];
}

template <class Cost>
class GoalSight {
 public:
  /// More than any cost.
  static constexpr Cost kInfinite = std::numeric_limits<Cost>::max();

  /// What is in sight of a cell.
  struct View {
    bool better = false;   // a goal at a smaller cost than all before
    bool nearest = false;  // the nearest goal: no path from here is shorter
  };

  /// Starts a search from a cell for these goals, at least one, on ground that tells passable() cells.
  void begin(std::span<const GoalRegion> regions, Cell start, const auto& ground) {
    goals_.assign(regions);
    cells_.clear();
    append_entrances(regions, start, [&](Cell cell) { return ground.passable(cell); }, cells_);
    best_ = kInfinite;
    overflown_ = false;
  }

  /// The cells at which a path may end.
  std::span<const Cell> cells() const { return cells_; }

  /// The estimate to the nearest goal.
  Cost h(Cell cell) const {
    return goals_.least(cell, [cell](Cell goal) { return octile_cost<Cost>(cell, goal); });
  }

  /// The cost of the cheapest path to a goal; kInfinite before a goal is in sight.
  Cost best() const { return best_; }
  /// The goal at its end.
  Cell goal() const { return goal_; }
  /// Did the cost of a path exceed the range of the type?
  bool overflown() const { return overflown_; }

  /// Finds the goals in sight of a cell that is reached at cost g. If the nearest goal is in sight, no
  /// path from there is shorter than the direct one to it. Goals outside `directions` are reached as
  /// cheaply by other paths. `sight` answers sees(from, to).
  View look(auto&& sight, Cell from, DirectionSet directions, Cost g) {
    View view;
    for (const Cell goal : cells_) {
      const bool ahead = (directions & first_direction(from, goal)) != 0 || goal == from;
      if (!ahead || !sight.sees(from, goal)) continue;
      const Cost distance = octile_cost<Cost>(from, goal);
      view.nearest = view.nearest || distance == h(from);
      if (distance >= kInfinite - g) {
        overflown_ = true;
        continue;
      }
      if (g + distance >= best_) continue;
      best_ = g + distance;
      goal_ = goal;
      view.better = true;
    }
    return view;
  }

 private:
  GoalCells goals_;
  std::vector<Cell> cells_;  // where a path enters them
  Cost best_ = kInfinite;
  Cell goal_{};
  bool overflown_ = false;
};

}  // namespace wend
