#pragma once

// Why a query of hybrid_astar has no drive, in sentences. Poses and lengths in cells, but for lengths of the
// resolution, which are in metres on maps in metres.

#include <string>

#include "wend/planner/plan.hpp"
#include "wend/planner/se2/hybrid_ground.hpp"
#include "wend/planner/se2/hybrid_resolution.hpp"

namespace wend {

/// How a search without a drive ended.
enum class WhyNoDrive {
  parted,          // not even the largest disc within the robot gets from the start to the goal
  goal_boxed_in,   // few poses lead to the goal, and the start is none of them
  start_boxed_in,  // the start leads to few poses, and the goal is none of them
  none_arrives,    // many poses lead to the goal, and the start is none of them
  none_leaves      // the start leads to many poses, and the goal is none of them
};

/// "the heading of the start is not a finite number"
std::string reason_of_headings(const Query& query);

/// What the map covers, of a start or a goal outside it.
std::string reason_of_outside_start(const FreeSpace& space, const Query& query);
std::string reason_of_outside_goal(const FreeSpace& space, const Query& query);

/// Why the robot does not fit at the start, or at a goal: which corner touches what.
std::string reason_of_blocked_start(const FreeSpace& space, const Query& query);
std::string reason_of_blocked_goal(const FreeSpace& space, const Query& query);

/// The resolution at which HybridPortfolio, which begins with `first`, has searched everywhere in this case: that of
/// its flood, or of its search `fine`.
HybridResolution searched_resolution(WhyNoDrive why, HybridResolution first);

/// Why the query is unreachable.
std::string reason_of_no_drive(WhyNoDrive why, const FreeSpace& space, const Query& query,
                               const HybridResolution& first);

}  // namespace wend
