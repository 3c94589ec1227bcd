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

/// "(1,1)>(2,1)>(3,1)" and a line end
std::string path_line(const Path& path, const Frame& frame);

/// Which of several goals was reached: a line.
std::string goal_line(const std::string& goal, std::size_t goals);

/// How far the ends of a path of cells are from what was asked, with its line end; empty if they are there.
std::string shift_line(const PlanResult& result, const Coordinates& coordinates);

/// A line that says that a planner without headings used the disc around the robot's polygon; empty
/// for any other robot.
std::string robot_line(const PlanResult& result);

/// What was found, a line for each thing.
std::string plan_summary(const PlanResult& result, const Frame& frame);

/// The same for a car's path. The coordinates are the user's.
std::string drive_summary(const PlanResult& result, const Coordinates& coordinates,
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
