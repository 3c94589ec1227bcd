#pragma once

// A plan as text.

#include <string>

#include "cli/arguments/coordinates.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {

/// What --times does, in help.
inline constexpr const char* kTimesHelp = "Also print times of all stages, and memory";

/// "3.5 us", "12.25 ms", "1.50 s"
std::string time_text(double seconds);

/// The path step by step, as lines: "(1,1)>(2,1)>(3,1)", or commands for a drive. Empty if the map is too large for
/// that to help; `small` says whether it is not.
std::string plan_steps(const PlanResult& result, const Coordinates& coordinates, bool small);

/// What was found and what it took, a line for each thing. The coordinates are the user's; `goals` were given.
std::string plan_summary(const PlanResult& result, const Coordinates& coordinates,
                         std::size_t goals);

/// What the search did, also for a failure. `states` names what was expanded: "cells".
std::string work_line(const SearchMetrics& metrics, const std::string& states = "cells");

/// For --times: how long the search and each stage before it took, and the most memory that the process held.
std::string times_lines(const WorkTimes& times);

/// "after 3.21 m, at (1.2,3.4) m, cell (24,68), it enters an obstacle: that at ..."
std::string collision_text(const PathCollision& collision, const Coordinates& coordinates);

/// "the path is not free: after 1.5 m, at (2,3) m, it leaves the map"
std::string not_free_text(const PathCollision& collision, const Coordinates& coordinates);

}  // namespace wend::cli
