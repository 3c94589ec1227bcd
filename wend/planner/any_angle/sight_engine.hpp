#pragma once

// What planners share whose paths turn at any angle: cells that see each other, nodes with any parent.
// Links choose the parents. A path is the cells at which it turns, joined by lines.

#include <memory>

#include "wend/planner/any_angle/any_angle_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/space/grid/sight_grid.hpp"

namespace wend {

/// The parts of a planner with such links; without an engine where there is terrain.
template <class Links, SightCheck kCheck>
GridPlanner::Parts any_angle_parts(const FreeSpace& space, const AnyAngleOptions<kCheck>& options) {
  using Engine = GridEngineOf<SightGrid, HeapFrontier<RealKey<double>>, RealEstimate<SightGrid>,
                              DuplicateRule::keep_cheaper, Links>;
  const GridMoves moves{Connectivity::eight, options.corner_rule};
  if (!space.uniform_terrain()) return {moves, nullptr, Plan::kNoBound, true};
  return {moves,
          std::make_unique<Engine>(
              SightGrid(space, options.corner_rule),
              RealEstimate<SightGrid>(HeuristicKind::euclidean, 0, 1, options.weight)),
          Plan::kNoBound, true};
}

}  // namespace wend
