#pragma once

// Corner rounding: replaces the corners of a path by arcs, so that a robot can drive it without
// stopping, and a robot that steers can drive it at all.
//
//   const auto curve = wend::rounded_corners(plan->path, space, 0.1);
//   if (!curve) return report(curve.error().message);
//
// Each corner becomes the widest arc that stays within a window of it (Corner, path_metrics.hpp).

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The path as poses joined by lines and arcs; in grid coordinates, as is the window
/// (>= 0). The robot fits along every arc: a corner whose arc would touch something remains, with a
/// turn in place, and so does a corner where the path turns back. So do all with a window of 0. A
/// path of poses is returned unchanged. Fails as fault_of() does (path_fault.hpp), and with invalid_option for a
/// window that is not finite or negative; with time_limit or cancelled if the deadline passes before it is done. O(n)
/// arcs, each as fits_along().
WEND_API Expected<Path, Error> rounded_corners(const Path& path, const FreeSpace& space,
                                               double window,
                                               Adjacency adjacency = Adjacency::edges,
                                               const Deadline& deadline = {});

}  // namespace wend
