#pragma once

// How far two paths are from each other: the largest distance from a point of either to the other (F. Hausdorff 1914).
//
//   const double moved = wend::largest_distance(plan->path, smoothed->path);  // cells

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/path/path.hpp"

namespace wend {

/// The largest distance in cells, of paths that are not empty and have no fault (path_fault.hpp). It looks at points
/// of both that are at most half a cell apart (of paths of more than 50,000 cells farther); what it leaves out is at
/// most half of that. O(n) for paths that lie near each other, O(n^2) at worst (A. Taha and A. Hanbury, "An Efficient
/// Algorithm for Calculating the Exact Hausdorff Distance", 2015). If the deadline passes before, it is an upper bound.
WEND_API double largest_distance(const Path& a, const Path& b, const Deadline& deadline = {});

}  // namespace wend
