#pragma once

// How messages name places and lengths on a map: in metres if its frame has a resolution, else in cells.
//
//   report("the robot stands at " + wend::pose_text(pose, map.frame()));
//
// Units (session/units.hpp) says the same in the units that a user has chosen.

#include <optional>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {

/// "(3,4)"
WEND_API std::string cell_text(Cell cell);

/// "(1.25,3.4) m": at most four digits after the point, a tenth of a millimetre.
WEND_API std::string metres_text(MapPoint point);

/// "S", or "26.57deg" in the map's frame for a heading between the four of a page.
WEND_API std::string heading_text(double radians, const Frame& frame);

/// "(0.1,0.05,S) m" on a map in metres, else "(2,1,S)", in grid coordinates; "any" without a heading.
WEND_API std::string pose_text(Point point, std::optional<double> heading, const Frame& frame);
/// The same of a pose.
WEND_API std::string pose_text(const Pose& pose, const Frame& frame);

/// "0.14 m" on a map in metres, else "2.83 cells".
WEND_API std::string distance_text(double cells, const Frame& frame);

/// What a map covers, in metres: "x from 0 to 4 m and y from -1 to 3 m"; the corners of one whose frame is turned.
WEND_API std::string covered_metres(const Frame& frame, int width, int height);

}  // namespace wend
