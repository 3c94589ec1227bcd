#pragma once

// Whether a planner's answer to a query of a MovingAI scenario is right.

#include <string>

#include "wend/base/status.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// How the cells of a path are joined.
enum class PathKind {
  steps,  // from neighbour to neighbour
  lines,  // at any angle: PlannerInfo::any_angle
};

/// What is wrong with an answer, or empty. Wrong answers: no path although the query has a length, a
/// path although the query says that there is no path, a path that does not join start and goal or
/// is not valid cell by cell, and a path that is shorter than the query's length or longer than the
/// plan's bound allows. On terrain the length is a cost. An answer that ran out of time is not wrong. A path of lines may
/// be shorter, for the query has the length of the shortest path of steps. O(length).
std::string wrong_answer(const FreeSpace& space, GridMoves moves, const ScenarioQuery& query,
                         Status status, const Plan& plan, PathKind kind = PathKind::steps);

}  // namespace wend
