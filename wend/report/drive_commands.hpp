#pragma once

// What a driver is told to do, for people: a line for the start, then one for each move with the
// corner and the heading where it ends.
//
//   Start (1,0,E)
//   Go FWD_RIGHT -> (2,1,S)
//   Go FWD -> (2,2,S)

#include <cstddef>
#include <string>

#include "wend/geometry/pose.hpp"
#include "wend/planner/plan.hpp"

namespace wend {

/// "(2,1,S)": grid coordinates, and the nearest of the four headings.
std::string corner_pose_text(const Pose& pose, bool y_up);

/// Of a driven plan, whose moves have names, in grid coordinates; empty if there is no path. Each
/// line has its line end.
std::string drive_commands(const Plan& plan, bool y_up);

/// How many of a driven plan's moves go backwards.
std::size_t steps_in_reverse(const Plan& plan);

}  // namespace wend
