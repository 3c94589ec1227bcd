#pragma once

// Trajectories as CSV, for controllers, spreadsheets and plotting programs:
//
//   t,x,y,heading,v,w
//   0,0.075,0.075,0,0,0
//   0.05,0.07625,0.075,0,0.05,0
//
// A line every period, and one for the end: the time in seconds, the pose in the map's frame (metres,
// and radians counter-clockwise from its +x), the speed in m/s, negative in reverse, and the turn rate
// in rad/s. On a map without a resolution a cell is a metre. Numbers read back exactly.

#include <string>

#include "wend/base/compiler.hpp"
#include "wend/io/file_error.hpp"
#include "wend/path/trajectory.hpp"

namespace wend {

/// `period` in seconds, > 0.
WEND_API std::string trajectory_csv(const Trajectory& trajectory, double period);

/// The file of a failed plan: the comment of no_path_csv() and the header.
WEND_API std::string no_trajectory_csv(const FailedPlan& plan);

}  // namespace wend
