#pragma once

// Why a query of hybrid_astar has no drive, in sentences: in metres on maps in metres, else in cells.

#include <string>

#include "wend/planner/plan.hpp"
#include "wend/planner/se2/no_drive_found.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// "the heading of the start is not a finite number"
std::string reason_of_headings(const Query& query);

/// What the map covers, of a start or a goal outside it.
std::string reason_of_outside_start(const FreeSpace& space, const Query& query);
std::string reason_of_outside_goal(const FreeSpace& space, const Query& query);

/// Why the robot does not fit at the start, or at a goal: which corner touches what.
std::string reason_of_blocked_start(const FreeSpace& space, const Query& query);
std::string reason_of_blocked_goal(const FreeSpace& space, const Query& query);

/// "no drive from ... to ... was found within 2 s of CPU time, the time_budget of hybrid_astar: ..."
std::string reason_of_time_budget(double seconds, const FreeSpace& space, const Query& query);

/// Why the query is unreachable.
std::string reason_of_no_drive(const NoDriveFound& why, const FreeSpace& space, const Query& query);

}  // namespace wend
