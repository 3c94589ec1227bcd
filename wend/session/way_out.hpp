#pragma once

// WayOut: the shortest way from a start where the robot does not fit to a place from which a planner can plan, along
// which the robot never overlaps more of what blocks it than before (robot/sweep/overlap.hpp).
//
// For a planner on cells it leads from cell to cell, with the planner's moves, for the disc around the robot. For a
// planner with headings it is made of motions that the planner's robot can drive: steps of a lattice; for hybrid_astar
// one line or arc, after turns in place if the robot makes them.
//
//   const auto way = wend::way_out(planner, query.start, 0.25 / resolution);
//   if (way) query.start = way->path.poses().back();

#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/planner.hpp"

namespace wend {

/// A way that leads out.
struct WayOut {
  Path path;          // of cells, or of poses: from the start's place to the first free one
  double length = 0;  // cells
};

/// Can the planner not begin at a pose that is on the map?
WEND_API bool is_blocked_start(const Planner& planner, const Pose& start);

/// The way out from a start, in grid coordinates, that is_blocked_start(), at most `most` cells long. Nothing if there
/// is none. O(places within that distance that the robot can reach without going deeper); of a planner with headings, at
/// most `places` of them.
WEND_API std::optional<WayOut> way_out(const Planner& planner, const Pose& start, double most,
                                       int places = 1000);

/// The same over cells, for a space and moves.
WEND_API std::optional<WayOut> way_out_over_cells(const FreeSpace& space, GridMoves moves,
                                                  Cell start, double most);

}  // namespace wend
