#pragma once

// dense_poses: the poses of a path, and more on its arcs, so that programs that join poses by straight
// lines follow them: pictures, other followers.
//
//   const auto poses = wend::dense_poses(path);  // lines between them are within 0.01 cells of it

#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// The poses of a path in grid coordinates, and more on its arcs: the straight lines between them stay
/// within `tolerance` (> 0) cells of the path, or a millionth of a cell if that is more. None for a path with a fault
/// (path_fault.hpp). At most kMostPosesAlong (polyline.hpp) on arcs. O(poses of the result).
WEND_API std::vector<Pose> dense_poses(const Path& path, double tolerance = 0.01);

}  // namespace wend
