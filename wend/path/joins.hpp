#pragma once

// Joins: the points of a path at which its legs meet, as indices of its cells, waypoints or poses. A leg goes from one
// join to the next, both included; the first begins at the path's start, the last ends at its end.
//
//   const std::array<std::size_t, 2> joins{4, 9};
//   const std::vector<wend::Path> legs = wend::legs_between(path, joins);  // three legs
//   const wend::Path same = wend::end_to_end(legs);

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// The points `first` to `last` of a path, both included: a path of the same kind. O(last - first).
WEND_API Path part_of(const Path& path, std::size_t first, std::size_t last);

/// A path that goes along each of these (one or more, none of them empty), which begins where the one before ends: that
/// point is a point of it once. Of cells if all are; of poses, if they are; else of waypoints. O(n).
WEND_API Path end_to_end(std::span<const Path> legs);

/// invalid_option for joins that are not points of a path of this size, or not in order. Several may be equal.
WEND_API std::optional<Error> fault_of_joins(std::span<const std::size_t> joins, std::size_t size);

/// The legs between valid joins, one more than joins. O(n).
WEND_API std::vector<Path> legs_between(const Path& path, std::span<const std::size_t> joins);

}  // namespace wend
