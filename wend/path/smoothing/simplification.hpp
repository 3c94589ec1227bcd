#pragma once

// Simplification: a path with fewer or other waypoints, its ends kept. What comes out of a free path
// is free, by the rules of first_collision(): a shortcut that is not is not taken. A polygon faces along
// its shortcuts and turns where they meet.
//
//   const auto fewer = wend::without_collinear(plan->path);
//   const auto taut = wend::string_pulled(plan->path, space);
//   if (!fewer || !taut) return report("the path cannot be simplified");
//
// Paths have cells or waypoints; a car's path can only be resampled. All functions fail with unsupported_query for
// another path and for one with a fault (path_fault.hpp), with invalid_option for a length out of range, and with
// time_limit or cancelled where a deadline passes before they are done. Lengths are in cells.

#include <cstdint>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// Without the points where the path goes straight on: the same way. O(n).
WEND_API Expected<Path, Error> without_collinear(const Path& path);

/// Ramer-Douglas-Peucker (U. Ramer 1972; D. Douglas and T. Peucker 1973): every point of the path
/// left out is within `tolerance` (finite, >= 0) of the line that replaces it. Where that line is not free
/// it is split on. O(n^2) at worst.
WEND_API Expected<Path, Error> simplified(const Path& path, double tolerance,
                                          const FreeSpace& space,
                                          Adjacency adjacency = Adjacency::edges,
                                          const Deadline& deadline = {});

/// From point to point of the path as far as sight leads, the swept disc fitting through, forwards and
/// backwards; of the points at which it bends either way the shortest way. Then, for a polygon, once more
/// forwards, its own shape fitting through. Never longer than the path. O(bends log n) sights tested.
WEND_API Expected<Path, Error> string_pulled(const Path& path, const FreeSpace& space,
                                             Adjacency adjacency = Adjacency::edges,
                                             const Deadline& deadline = {});

/// No path is resampled to more points than these.
inline constexpr std::uint64_t kMostResampled = 1'000'000;

/// Points at equal distances along, as near to `spacing` (finite, > 0) as divides the length; between two of
/// them the path's own points stay where the straight line is not free. Of a drive: its arcs divided.
/// invalid_option for a spacing of more than kMostResampled points, too.
WEND_API Expected<Path, Error> resampled(const Path& path, double spacing, const FreeSpace& space,
                                         Adjacency adjacency = Adjacency::edges,
                                         const Deadline& deadline = {});

}  // namespace wend
