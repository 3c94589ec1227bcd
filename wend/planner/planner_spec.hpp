#pragma once

// PlannerSpec: a planner and its options in one word, as people type them in lists:
//
//   astar,bfs:connectivity=4,astar:weight=2,heuristic=euclidean

#include <string_view>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

using PlannerSpec = OptionSpec;

/// The planners of a list. Fails with invalid_option for an unknown planner, a word that is not
/// name=value, and an empty list; whether the options fit is for PlannerInfo::make to say.
Expected<std::vector<PlannerSpec>, PlannerError> parse_planner_specs(std::string_view list);

/// How a planner moves on a grid, as far as its options say; values that are none count as not given.
GridMoves moves_of(const PlannerSpec& planner);

}  // namespace wend
