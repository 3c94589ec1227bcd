#pragma once

// fault_of: which point of a path no computation can use, and why: one that contains NaN or infinity, or is so
// far away that numbers are no longer exact, or that time would depend on its size.
//
//   if (const auto fault = wend::fault_of(*taut, space)) return report(fault->message);
//
// Everything that computes with paths asks it first, and fails as it does: metrics, simplification, smoothers,
// corner rounding, trajectories. first_collision() has a path with a fault leave the map.

#include <cstddef>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/near_map.hpp"

namespace wend {

/// unsupported_query for an empty path, and for one with a number that is NaN or infinite, a point beyond
/// kFarthestPoint or a heading beyond kLargestHeading; nothing for others. Error::where is the point, as "point 3",
/// counted from 0. O(n).
WEND_API std::optional<Error> fault_of(const Path& path);

/// The same, and for a point that is not near_map(). In metres where the map is.
WEND_API std::optional<Error> fault_of(const Path& path, const FreeSpace& space);

/// How many points of a path come before the first one with a fault, as fault_of(path) says it; all if it has none.
/// O(n).
WEND_API std::size_t points_without_fault(const Path& path);

}  // namespace wend
