#pragma once

// plan_coverage(): a path on which the tool of a robot passes over every place that it can reach.
//
// The tool is a disc in the middle of the robot, at its base point. A cell counts as covered if its centre is at most half
// the tool's width from the path; a tool wider than the robot reaches over obstacles. The robot drives where it fits at every
// heading, also outside of the area that is to be covered. What is to be covered are the cells that are not blocked
// and that the tool covers from the middle of a cell that the robot can reach.
//
// First come strips along the walls, which can only be covered from there; then swaths, parallel strokes over what is
// left, each room at the angle that is cheapest there; then short strokes over the crumbs. The order of all strokes is a tour
// (plan_tour()), and between them the robot drives the shortest free way. Every line is swept exactly.
//
//   const auto coverage = wend::plan_coverage(space, {.tool_width = 0.35});
//   if (!coverage) return report(coverage.error().message);
//   std::cout << coverage->length << " m, " << 100 * coverage->covered_share << " %\n";
//
// The path is not the shortest one. Its length is about 1.1 times the lower bound in halls and 1.2 times among furniture;
// docs/coverage.md has measurements. The same input gives the same path on every platform, unless time ran out.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/path/path.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// What to cover, and how. Lengths are in metres (cells if the map's resolution is 1), points in grid coordinates.
struct CoverageOptions {
  double tool_width = 0;  // from 2 to 500 cells
  double overlap = 0;     // of neighbouring swaths; from 0 to below the tool's width
  std::optional<double> angle =
      {};  // of all swaths, radians from +x; unset: each room its cheapest one
  std::optional<double> turn_cost =
      {};                // what turning around costs, as a length; unset: the tool's width
  double share = 0.999;  // of what the tool can reach: as much is covered; above 0, at most 1
  std::optional<Point> start =
      {};  // where the path begins, or the middle of its cell; unset: anywhere in the largest component
  std::optional<Point> end = {};        // where it ends; unset: anywhere
  std::optional<BitGrid> area = {};     // the cells to cover, as large as the map; unset: all
  std::optional<BitGrid> covered = {};  // cells that are covered already, as large as the map
  std::uint64_t seed = 1;               // of the search for the order
  Limits limits = {};                   // `seconds`, `clock` and `cancel`, of the whole call
};

/// A path that covers an area, and what it covers.
struct Coverage {
  Path path;                // waypoints; empty if there is nothing left to cover
  std::size_t strokes = 0;  // strips, swaths and crumbs, which ways join
  double length = 0;        // metres, of the path
  double lower_bound =
      0;  // metres: what the path covers divided by the tool's width. No path covers it on less,
          // but for the tool's own length
  std::size_t turns = 0;     // where the direction changes by more than 20 degrees
  double covered_share = 1;  // of what the tool can reach; what was covered before counts
  BitGrid wanted;            // the cells that the tool can reach, in the area
  BitGrid covered;           // those that the path covers, or that were covered before
  BitGrid unreached;         // cells of the area that are free, and that the tool cannot reach
};

/// The path. Fails with invalid_option for numbers out of range, and areas of another size than the map; with start_outside,
/// start_blocked, goal_outside, goal_blocked (the end) unreachable (from start to end, or where the robot fits nowhere or the tool reaches nothing of the area);
/// memory_limit for more than some thousand strokes, whose order takes too much memory;
/// with time_limit or cancelled if there is no path before. O(cells + strokes^2) and the order's search.
WEND_API Expected<Coverage, Error> plan_coverage(const FreeSpace& space,
                                                 const CoverageOptions& options);

/// A place that was not covered, and why.
struct MissedPlace {
  Cell cell;               // one of its cells
  std::size_t cells = 0;   // how many cells hang together there
  bool reachable = false;  // the tool could reach it; it was left out for CoverageOptions::share
  std::optional<double> radius =
      {};  // the radius of the widest robot that gets there, in metres; unset: not even a point
};

/// The largest places that were not covered, at most `most`, the largest first. O(cells log cells) for each.
WEND_API std::vector<MissedPlace> missed_places(const FreeSpace& space, const Coverage& coverage,
                                                std::size_t most);

}  // namespace wend
