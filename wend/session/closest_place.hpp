#pragma once

// The reachable places that are nearest to goals which no path reaches.
//
// For a planner on cells these are the passable cells that are connected to the start's, exactly: all whose middles are
// at the least distance from a goal's point. A planner with headings finds them by searches with growing tolerances, with
// any heading: it begins with what its inscribed disc can reach, and the place that it ends at is nearer than any other
// that it can reach, up to half a cell.

#include <optional>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner.hpp"

namespace wend {

/// Goals that a planner can reach, in place of others.
struct ClosestPlaces {
  std::vector<Goal> goals;  // the cheapest path to them is the answer
  double distance = 0;      // cells, at most, to the nearest of the goals that were asked for
};

/// The closest places for a query whose start the planner accepts, at most `most` cells away from a goal. Nothing if there
/// are none, or the deadline passes before they are found. O(cells) for a planner on cells, else some searches, each with
/// the limits of the query.
std::optional<ClosestPlaces> closest_places(Planner& planner, const Query& query, double most,
                                            const Deadline& deadline = {});

/// The same for a planner on cells, without a search.
std::optional<ClosestPlaces> closest_cells(const Planner& planner, const Query& query, double most,
                                           const Deadline& deadline = {});

/// The distance from a point to the nearest of the goals' points, in cells.
double distance_to_goals(Point point, const std::vector<Goal>& goals);

}  // namespace wend
