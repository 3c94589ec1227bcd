#pragma once

// Paths as CSV, for spreadsheets and plotting programs:
//
//   x,y,x_m,y_m
//   1,1,0.075,0.075
//   2,1,0.125,0.075
//
// One line for each cell, including start and goal: column and row, then the cell's centre in the map's
// frame, in metres (cells for a map without a resolution); of the first and the last cell, the point at which the path
// begins and ends, if that is not the centre. A cell may then be repeated. A driven path has one line for each pose:
//
//   x,y,heading,x_m,y_m,yaw,gear
//   1,0,E,0.05,0,0,1
//   2,1,S,0.1,0.05,1.5707963267948966,1
//
// The point in grid coordinates (a car stands on corners, which are whole numbers) and the heading,
// N, W, E or S as drawn; any other is a number, radians from +x towards +y of the grid. Then the
// same in the map's frame: metres, and radians counter-clockwise from its +x. The gear is that of the piece
// that leads to the pose (gears_of(); of the first pose, of the piece that begins there): 1 ahead, -1 in
// reverse, 0 for a turn in place. It is not read back, as the poses say it; files without it are read too.
//
// A path of waypoints has one line for each waypoint:
//
//   x_grid,y_grid,x_m,y_m,yaw
//   1.5,1.5,0.075,0.075,0
//   2.25,1.5,0.1125,0.075,0.3
//
// The point in grid coordinates, then in the map's frame, and the heading of the path there: towards
// the next waypoint (the last one repeats it), in radians counter-clockwise from the frame's +x.
//
// A failed plan has a comment with the status and the reason, the header, and no points:
//
//   # no path: unreachable: no path joins start (1,1) and goal (8,5)
//   x,y,x_m,y_m
//
// Numbers read back exactly; load_path() reads the cells, the poses or the waypoints.

#include <string>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/io/file_error.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// The file of a path (in grid coordinates, not empty) on a map with this frame. O(n).
WEND_API std::string path_csv(const Path& path, const Frame& frame);

/// The file of a failed plan, with a header of the columns. It replaces an older path, so that no robot
/// executes an outdated one.
WEND_API std::string no_path_csv(const FailedPlan& plan, std::string_view header = "x,y,x_m,y_m");

}  // namespace wend
