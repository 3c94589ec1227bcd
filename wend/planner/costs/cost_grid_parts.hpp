#pragma once

// The parts of planners that search on a CostGrid: the grid with the words that its costs need, engines whose costs
// become wider where they have to, and what follows an edit.

#include <cstdint>
#include <memory>
#include <utility>

#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// Engine<Cost, Word, Units> on a grid, in 32 bits while they do if the words have as many. `compact` is what only the
/// engine in 32 bits is made with, besides grid and parts.
template <template <class, class, class> class Engine, class Word, class... Compact>
std::shared_ptr<GridEngine> widening_engine_on(const std::shared_ptr<const CostGrid<Word>>& grid,
                                               const BestFirst& parts, const Compact&... compact) {
  using Wide = std::uint64_t;
  if constexpr (sizeof(Word) == sizeof(Wide)) {
    return std::make_shared<Engine<Wide, Word, CostUnits>>(grid, parts);
  } else {
    const auto widening = [&]<class Units, class WideUnits>() {
      return std::make_shared<WideningEngine<GridEngine>>(
          [&] { return std::make_unique<Engine<Word, Word, Units>>(grid, parts, compact...); },
          [grid, parts] { return std::make_unique<Engine<Wide, Word, WideUnits>>(grid, parts); });
    };
    if (grid->one() != 1) return widening.template operator()<CostUnits, CostUnits>();
    return widening.template operator()<OctileUnits<Word>, OctileUnits<Wide>>();
  }
}

/// The parts with an engine that follows the repairs of its grid.
template <class Word, class Remake>
GridPlanner::Parts parts_on_grid(const std::shared_ptr<CostGrid<Word>>& grid,
                                 const std::shared_ptr<GridEngine>& engine, const BestFirst& parts,
                                 const Remake& remake) {
  GridPlanner::Parts made{parts.moves, engine, parts.bound()};
  made.repaired = [=](const FreeSpace& space, const SpaceChange& change) {
    if (!grid->can_become(space)) return remake(space);
    grid->repair(space, change);
    return parts_on_grid(grid, engine, parts, remake);
  };
  return made;
}

/// Makes a grid for a space, make_engine(grid) on it, and the parts of both. remake(space) makes them for a space
/// that the grid cannot become.
template <class MakeEngine, class Remake>
GridPlanner::Parts cost_grid_parts(const FreeSpace& space, const BestFirst& parts,
                                   MakeEngine&& make_engine, const Remake& remake,
                                   DeadlineCheck& stop) {
  const auto on = [&]<class Word>() {
    const auto grid = std::make_shared<CostGrid<Word>>(space, parts.moves, stop);
    if (stop.has_passed()) return GridPlanner::Parts{};
    return parts_on_grid(grid, std::shared_ptr<GridEngine>(make_engine(grid)), parts, remake);
  };
  if (CostGrid<std::uint32_t>::holds(space.costs())) {
    return on.template operator()<std::uint32_t>();
  }
  return on.template operator()<std::uint64_t>();
}

}  // namespace wend
