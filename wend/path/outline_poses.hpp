#pragma once

// outline_poses: the poses at which a picture shows the outline of a robot along its path: the start, the
// goal, and evenly between them, with gaps in which the path is visible.
//
//   const auto outlines = wend::outline_poses(path, 0.5);  // of a robot that is a cell wide

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/path/polyline.hpp"

namespace wend {

/// Poses along a path (not empty), in grid coordinates, for a robot that a disc of `radius` (> 0, cells)
/// covers: 1.6 widths of the disc apart or a little more, and at most 201. On a path of poses with the
/// path's headings, else along the way. None for a path with a fault (path_fault.hpp), the two ends for a radius that
/// is NaN. O(n).
WEND_API std::vector<Pose> outline_poses(const Path& path, double radius);

/// The same on a polyline, heading along it.
WEND_API std::vector<Pose> outline_poses(const Polyline& line, double radius);

}  // namespace wend
