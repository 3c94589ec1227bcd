#pragma once

// Query: from where, to where, with what limits, and who watches.

#include <optional>
#include <utility>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class SearchObserver;

/// Where a path may end, in grid coordinates. A pose is a goal; a point is one with any heading.
struct Goal {
  Point point;
  std::optional<double> heading;  // radians; nothing: any will do

  // NOLINTNEXTLINE(google-explicit-constructor): a pose is a goal
  Goal(const Pose& pose) : point(pose.point()), heading(pose.heading) {}
  explicit Goal(Point where) : point(where) {}
};

/// In grid coordinates. A grid planner takes the cells that start and goal lie in, whatever the
/// headings; a car the nearest corners and headings of its lattice (Plan says how near). With
/// several goals the cheapest one is found.
struct Query {
  Pose start;
  std::vector<Goal> goals;
  Limits limits = {};
  SearchObserver* observer = nullptr;  // told every event of the search; not owned

  static Query between(Cell start, Cell goal) { return {pose_at(start), {pose_at(goal)}}; }
};

}  // namespace wend
