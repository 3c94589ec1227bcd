#pragma once

// The map with what was asked for.

#include "cli/arguments/coordinates.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/scene.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

/// The cells that the goals of a query lie in.
std::vector<Cell> cells_of_goals(const Query& query, const Units& units);

/// The map with the start and the goals of a query: cells, or poses where the planner's states have headings.
Scene query_scene(const PlannerSpec& planner, const FreeSpace& space, const Query& query);

/// The same with the reason why a planner with these moves found no path, as far as it can be drawn: components and the
/// widest path apply to planners on cells.
Scene failure_scene(const PlannerSpec& planner, const FreeSpace& space, const Query& query,
                    Status status, GridMoves moves, const Coordinates& coordinates);

}  // namespace wend::cli
